#lang racket/base
;; Pictures of frames, in the formats that editors and documents ask for, and in files.

(require file/convertible
         (prefix-in g: (only-in mechanics * - cos ref))
         mechanics/plot
         (only-in mechanics/show/plot/on-demand why-not)
         (only-in mechanics/show/plot/svg-digits shortened-svg)
         (only-in pict pict-width pict-height)
         (only-in racket/class dynamic-send)
         racket/file
         (only-in racket/list remove-duplicates)
         racket/serialize
         racket/string
         "../../support/checks.rkt" "../../support/folder.rkt"
         "../../support/messages.rkt" "../../support/picture-programs.rkt" "../../support/skip.rkt"
         "../../support/svg.rkt")

(define drawable? (not (why-not)))
(define no-drawing "the shared libraries of racket/draw are not installed: no pictures")

(define (drawn)
  (define f
    (frame 0 1 -1 1 #:title "A title" #:x-label "x" #:y-label "y" #:width 300 #:height 200))
  (plot-function f (lambda (x) (- 1 x)) 0 1 #:color '(10 20 200) #:label "falling")
  (plot-line f 0 0 1 1 #:color "red" #:style 'dot)
  (for ([i (in-range 20)]) (plot-point f (/ i 20) 0 #:color 'green))
  f)

;; ---------------------------------------------------------------------------
;; PNG, by the book: a signature, then the header chunk with width and height

(define (png-size bytes)
  (check-equal? (subbytes bytes 0 8) #"\211PNG\r\n\32\n")
  (check-equal? (subbytes bytes 12 16) #"IHDR")
  (list (integer-bytes->integer bytes #f #t 16 20) (integer-bytes->integer bytes #f #t 20 24)))

;; -> the width in pixels, and alpha, red, green and blue of each
(define (png-pixels png)
  (define (draw-library name) (dynamic-require 'racket/draw name))
  (define picture ((draw-library 'read-bitmap) (open-input-bytes png)))
  (define (call name . arguments) (apply dynamic-send picture name arguments))
  (define-values (width height) (values (call 'get-width) (call 'get-height)))
  (define bytes (make-bytes (* 4 width height)))
  (call 'get-argb-pixels 0 0 width height bytes)
  (values width bytes))

;; How many pixels are red, and no paler than half
(define (red-pixels png)
  (define-values (_width bytes) (png-pixels png))
  (for/sum ([k (in-range 0 (bytes-length bytes) 4)])
    (if (and (> (bytes-ref bytes (+ k 1)) 200) (< (bytes-ref bytes (+ k 2)) 128)) 1 0)))

(skip-unless drawable? no-drawing

  (test-case "points are as bold as they can be; the more there are, the smaller"
    (define (pixels-each n . size)
      (define f (frame 0 1 0 1))
      (define state (make-pseudo-random-generator))
      (parameterize ([current-pseudo-random-generator state])
        (random-seed 1)
        (for ([_ (in-range n)])
          (keyword-apply plot-point (map (lambda (s) '#:size) size) size (list f (random) (random))
                         #:color '(255 0 0))))
      (/ (red-pixels (convert f 'png-bytes)) n 1.0))
    (define-values (few more many)
      (values (pixels-each 30) (pixels-each 1000) (pixels-each 4000)))
    (check-true (> few 15.0) (format "~a" few))
    (check-true (> few more many) (format "~a, ~a, ~a" few more many))
    (check-true (> many 2.0) (format "~a" many))
    (check-true (> (pixels-each 21000 5) (pixels-each 21000))))

  (test-case "a power is a straight line on logarithmic axes, and what has no logarithm is left out"
    (define (red f draw)
      (draw f)
      (red-pixels (convert f 'png-bytes)))
    (define (power f) (plot-function f (lambda (x) (- (expt x -2) 1e-9)) 1 100 #:color 'red))
    (define (diagonal f) (plot-line f 1 1 100 1e-4 #:color 'red))
    (define (decades) (frame 1 100 1e-4 1 #:x-scale 'log #:y-scale 'log))
    (check-true (< 0.9 (/ (red (decades) power) (red (decades) diagonal)) 1.1))
    (check-equal? (red (decades) (lambda (f) (plot-line f -5 1 50 -1 #:color 'red))) 0))

  (test-case "a bar tells what colours mean, and takes room from the picture"
    (define (width bar?)
      (define f (frame 0 1 0 1))
      (chaos-map f (lambda (x y return fail) (fail)) 10 #:samples 40 #:bar? bar?)
      (define read-bitmap (dynamic-require 'racket/draw 'read-bitmap))
      (define picture (read-bitmap (open-input-bytes (convert f 'png-bytes))))
      (define row (make-bytes (* 4 400)))
      (dynamic-send picture 'get-argb-pixels 0 150 400 1 row)
      (for/sum ([k (in-range 0 1600 4)])
        (if (equal? (subbytes row (+ k 1) (+ k 4)) (bytes 190 190 190)) 1 0)))
    (check-true (< 250 (width #t) (- (width #f) 30))))

  (test-case "cells of an image are sharp, however few"
    (define f (frame 0 1 0 1))
    (define (falls x y return fail) (if (< x 0.5) (fail) (return x y)))
    (chaos-map f falls 10 #:samples 2)
    (define-values (width bytes) (png-pixels (convert f 'png-bytes)))
    (define row (* 4 width 100))
    (define (color k) (subbytes bytes (+ row (* 4 k) 1) (+ row (* 4 k) 4)))
    ;; grey, the other colour and at most a mixture between them
    (check-true (<= (length (remove-duplicates (for/list ([k (in-range 60 380)]) (color k)))) 3)))

  (test-case "the size of a point is its diameter in pixels"
    (define f (frame 0 1 0 1))
    (plot-point f 1/2 1/2 #:size 20 #:color 'red)
    (check-true (< 300 (red-pixels (convert f 'png-bytes)) 330)))

  (test-case "formats"
    (define f (drawn))
    (check-equal? (png-size (convert f 'png-bytes)) '(300 200))
    (check-equal? (png-size (convert f 'png@2x-bytes)) '(600 400))
    (define pdf (bytes->string/latin-1 (convert f 'pdf-bytes)))
    (check-true (string-prefix? pdf "%PDF-"))
    (check-regexp-match #px"/MediaBox \\[ ?0 0 240 160 ?\\]" pdf)
    (check-equal? (string-length pdf) (bytes-length (convert (frame->pict f) 'pdf-bytes)))
    (check-regexp-match #rx"^<[?]xml.*<svg " (bytes->string/utf-8 (convert f 'svg-bytes)))
    (check-false (convert f 'no-such-format))
    (check-equal? (convert f 'no-such-format 'default) 'default))

  (test-case "a picture holds the curve, the line and the points"
    (define svg (bytes->string/utf-8 (convert (drawn) 'svg-bytes)))
    (check-not-equal? (strokes svg '(10 20 200)) '())
    (check-not-equal? (strokes svg '(255 0 0)) '())
    (check-equal? (length (strokes svg '(0 255 0))) 20)
    (check-equal? (strokes svg '(255 255 0)) '()))

  ;; An image holds them, of which SVG has but one.
  (test-case "very many points are one image, with axes and a legend as for few"
    (define (dotted n)
      (define f (frame 0 1 0 1))
      (for ([k (in-range n)])
        (plot-point f 0.5 (/ k n) #:color 'red #:label "dots"))
      (bytes->string/utf-8 (convert f 'svg-bytes)))
    (define-values (few many) (values (dotted 100) (dotted 30000)))
    (check-equal? (length (strokes few '(255 0 0))) 101)
    (check-equal? (length (strokes many '(255 0 0))) 1)
    (check-equal? (length (regexp-match* #rx"<image " few)) 0)
    (check-true (pair? (regexp-match* #rx"<image " many)))
    (check-equal? (length (strokes many '(0 0 0))) (length (strokes few '(0 0 0)))))

  (test-case "nothing is drawn outside"
    (define (count-blue f)
      (length (strokes (bytes->string/utf-8 (convert f 'svg-bytes)) '(0 0 255))))
    (define f (frame 0 1 0 1))
    (plot-line f 2 2 3 3 #:color 'blue)
    (plot-function f (lambda (x) 5) 0 1 #:color 'blue)
    (check-equal? (count-blue f) 0)
    (plot-line f 0 0 3 3 #:color 'blue)
    (check-equal? (count-blue f) 1))

  (test-case "levels are drawn where the function has them, and its poles are no trouble"
    (define f (frame -1 1 -1 1 #:aspect-ratio 'equal))
    (define (well x y) (- (/ (sqrt (+ (* x x) (* y y))))))
    (define (blue)
      (apply + (strokes (bytes->string/utf-8 (convert f 'svg-bytes)) '(0 0 255))))
    (plot-contours f well '(-0.1) #:color 'blue)
    (check-equal? (blue) 0)
    (plot-contours f well '(-2 -3) #:color 'blue #:samples 51)
    (check-true (> (blue) 100)))

  (test-case "a default phase portrait is a few curves, each in one piece, of few bytes"
    (define f (frame -3.2 3.2 -10.0 10.0))
    (define (energy state)
      (g:- (g:* 1/2 (g:ref state 2) (g:ref state 2)) (g:* 9.8 (g:cos (g:ref state 1)))))
    (plot-phase-portrait f energy)
    (define svg (convert f 'svg-bytes))
    (check-true (< (bytes-length svg) 50000) (format "~a bytes" (bytes-length svg)))
    (define lines (strokes (bytes->string/utf-8 svg) '(190 190 190)))
    (check-true (<= 12 (length lines) 24) (format "~a" lines))
    (check-true (> (apply min lines) 10)))

  (test-case "points on straight pieces are not drawn, and dashes are those of the line"
    (define f (frame 0 10 0 10))
    (plot-function f (lambda (x) (if (< x 5) x 5)) 0 10 #:color 'blue)
    (plot-line f 0 1 10 1 #:color 'red #:style 'dot)
    (define svg (bytes->string/utf-8 (convert f 'svg-bytes)))
    (check-true (< (apply + (strokes svg '(0 0 255))) 110))
    (check-equal? (strokes svg '(255 0 0)) '(2))
    (check-regexp-match #rx"<path [^>]*stroke-dasharray[^>]*>" svg))

  (test-case "a legend has a line for each label, in the order of drawing"
    (define (with-labels . labels)
      (define f (frame 0 1 0 1))
      (for ([label (in-list labels)] [k (in-naturals 1)])
        (plot-line f 2 2 3 3 #:color (list k k k) #:label label))
      (bytes->string/utf-8 (convert f 'svg-bytes)))
    (define svg (with-labels "one" #f "two"))
    (define (heights k)
      (map (lambda (m) (string->number (cadr m)))
           (regexp-match* (pregexp (format "stroke:rgb[(]~a[^>]* d=\"M [\\d.]+ ([\\d.]+) L" k))
                          svg #:match-select values)))
    (check-equal? (map length (list (strokes svg '(1 1 1)) (strokes svg '(2 2 2))
                                    (strokes svg '(3 3 3))))
                  '(1 0 1))
    (check-true (< (apply + (heights "0.39")) (apply + (heights "1.17")))))

  (test-case "numbers of colors are those that they were"
    (define color->bytes (dynamic-require 'mechanics/show/plot/plot-colors 'color->bytes))
    (check-equal? (map color->bytes '(0 1 2 3 4 5 6 7 -3 128 red (10 20 200)))
                  '((0 0 0) (127 0 0) (7 129 0) (0 2 123) (169 96 0) (0 54 85) (85 0 169)
                    (146 0 71) (67 67 67) (0 0 0) (255 0 0) (10 20 200))))

  (test-case "the picture is the present one"
    (define f (drawn))
    (define before (convert f 'png-bytes))
    (check-equal? (convert f 'png-bytes) before)
    (plot-line f 0 1 1 0)
    (check-not-equal? (convert f 'png-bytes) before)
    (graphics-clear f)
    (check-true (< (bytes-length (convert f 'png-bytes)) (bytes-length before))))

  (test-case "a pict of a frame stays as it was made"
    (define f (frame 0 1 0 1 #:width 320 #:height 240))
    (define p (frame->pict f))
    (define before (convert p 'png-bytes))
    (check-equal? (list (pict-width p) (pict-height p)) '(320 240))
    (check-equal? before (convert f 'png-bytes))
    (plot-line f 0 1 1 0)
    (check-equal? (convert p 'png-bytes) before))

  (test-case "an empty frame, and one with nothing in sight, have pictures"
    (define f (frame 0 1 0 1))
    (check-equal? (png-size (convert f 'png-bytes)) '(400 400))
    (plot-point f 2 2)
    (plot-function f (lambda (x) +nan.0) 0 1)
    (check-equal? (png-size (convert f 'png-bytes)) '(400 400)))

  (test-case "frames of all sizes, with whatever there may be in them"
    (define (drawn-in f)
      (plot-point f 1/2 1/2 #:size 1000 #:label "a label for which there is no room")
      (plot-line f -1e308 -1e308 1e308 1e308 #:width 0 #:label "")
      (plot-function f (lambda (x) (/ 1e300 (- x 0.50001))) 0 1)
      (plot-contours f (lambda (x y) (g:* x y)) 0.1 #:samples 11)
      (for ([format '(svg-bytes png-bytes pdf-bytes)]) (check-pred bytes? (convert f format))))
    (drawn-in (frame 0 1 0 1 #:width 50 #:height 50 #:title "a long title" #:y-label "y"))
    (drawn-in (frame 0 1 0 1 #:aspect-ratio 100))
    (for ([bounds '((0 5e-324) (1 1.0000000000000002) (-1e308 1e308) (1e300 1e301))])
      (drawn-in (frame (car bounds) (cadr bounds) 0 1))))

  (test-case "a hundred thousand points"
    (define f (frame 0 1 0 1))
    (for ([i (in-range 100000)])
      (plot-point f (/ (modulo (* i 7919) 100003) 100003.0)
                  (/ (modulo (* i 104729) 100019) 100019.0)))
    (check-equal? (png-size (convert f 'png-bytes)) '(400 400)))

  (test-case "names of colors are those of the drawing library"
    (define f (frame 0 1 0 1))
    (plot-point f 0 0 #:color "Steel Blue")
    (plot-point f 0 0 #:color 'steelblue)
    (check-exn #rx"expected a color: .*\n  given: the symbol bleu"
               (lambda () (plot-point f 0 0 #:color 'bleu)))
    (check-equal? (length (frame-points f)) 2)))

;; ---------------------------------------------------------------------------
;; Files

(skip-unless drawable? no-drawing

  (test-case "the name of the file says the format; what was there is replaced"
    (with-folder (folder)
      (define (save name) (graphics-save (drawn) (build-path folder name)))
      (for ([name '("a.png" "b.svg" "c.pdf" "D.PNG" "a.png")]) (save name))
      (check-equal? (map path->string (directory-list folder)) '("D.PNG" "a.png" "b.svg" "c.pdf"))
      (check-equal? (png-size (file->bytes (build-path folder "a.png"))) '(300 200))
      (check-true (regexp-match? #rx"<svg " (file->string (build-path folder "b.svg"))))
      (check-true (regexp-match? #rx"^%PDF-" (file->bytes (build-path folder "c.pdf"))))
      (parameterize ([current-directory folder])
        (graphics-save (drawn) "e.png"))
      (check-true (file-exists? (build-path folder "e.png")))))

  (test-case "where nothing can be written, nothing is left, and what was there stays"
    (with-folder (folder)
      (define (save . names) (graphics-save (drawn) (apply build-path folder names)))
      (check-exn #rx"graphics-save: there is no such folder\n  file: .*a.png\n  reason: .*nowhere"
                 (lambda () (save "nowhere" "a.png")))
      (make-directory (build-path folder "b.png"))
      (check-exn #rx"graphics-save: there is a folder of that name\n  file: .*b.png$"
                 (lambda () (save "b.png")))
      (check-equal? (map path->string (directory-list folder)) '("b.png")))))

(define (saved f name . options)
  (with-folder (folder)
    (define file (build-path folder name))
    (keyword-apply graphics-save '(#:centimeters #:font #:font-size) options (list f file))
    (file->bytes file)))

(skip-unless drawable? no-drawing

  (test-case "a title stands above the ticks, in any size of letters"
    (define f (frame 0 1 0 1 #:title "title"))
    (define-values (width bytes) (png-pixels (saved f "a.png" 8 #f 8)))
    (define (white-row? j)               ; but for its last pixel
      (for/and ([k (in-range (* 4 width j) (* 4 (- (* width (+ j 1)) 1)))])
        (= 255 (bytes-ref bytes k))))
    (define top (for/first ([j (in-naturals)] #:unless (white-row? j)) j))
    (define below (for/first ([j (in-naturals top)] #:when (white-row? j)) j))
    (check-true (< (- below top) 40)))

  (test-case "text in an SVG that is saved is text, fitted to its place"
    (define f (frame 0 1 0 1 #:x-label "a < b & c" #:y-label "up" #:width 300 #:height 200))
    (define svg (bytes->string/utf-8 (saved f "a.svg" #f #f 9)))
    (check-true (string-contains? svg ">a &lt; b &amp; c</text>"))
    (check-regexp-match #px"transform=\"rotate\\(-90 [0-9. ]+\\)\">up</text>" svg)
    (check-false (regexp-match? #rx"<symbol|glyph" svg)))

  (test-case "a text is as long as its letters; a number stands at its place on a logarithmic axis"
    (define f (frame 1 100 0 1 #:x-scale 'log #:width 300 #:height 200))
    (plot-line f 10 0 10 1 #:color 'red)
    (define svg (bytes->string/utf-8 (saved f "log.svg" #f #f 9)))
    (define (of-text text)
      (define pattern (format "<text x=\"([\\d.]+)\"[^>]*textLength=\"([\\d.]+)\">~a</text>" text))
      (apply values (map string->number (cdr (regexp-match (pregexp pattern) svg)))))
    (define-values (left length) (of-text "10"))
    (define-values (_ longer) (of-text "100"))
    (check-= longer (* 3/2 length) 0.1)
    (define line (regexp-match #px"stroke:rgb[(]100%, *0%, *0%[)][^>]* d=\"M ([\\d.]+)" svg))
    (check-= (string->number (cadr line)) (+ left (/ length 2)) 0.6))

  (test-case "a figure for print has its width in centimetres and letters of a size in points"
    (define f (drawn))
    (check-equal? (car (png-size (saved f "a.png" 5.08 #f 9))) 600)
    (define pdf (bytes->string/latin-1 (saved f "a.pdf" 8.6 #f 9)))
    (define box (map string->number (cdr (regexp-match #px"/MediaBox \\[ ?0 0 (\\d+) (\\d+)" pdf))))
    (check-true (<= (abs (- (car box) (* 8.6 (/ 72 2.54)))) 1) (format "~a" box))
    (check-true (<= (abs (- (/ (car box) (cadr box)) 3/2)) 0.02))
    (define (unit points)             ; in centimetres
      (define svg (bytes->string/utf-8 (saved f "a.svg" 8.6 "Palatino" points)))
      (check-true (string-contains? svg "font-family=\"Palatino\""))
      (check-true (string-contains? svg "font-size=\"12.00\""))
      (define m (regexp-match #px"width=\"([0-9.]+)cm\".*viewBox=\"0 0 ([0-9.]+) " svg))
      (/ (string->number (cadr m)) (string->number (caddr m))))
    (for ([points '(7 9 12)])
      (check-true (<= 0.98 (/ (* 12 (unit points)) (* points (/ 2.54 72))) 1.02))))

  (test-case "panels of a figure: a row of frames, or rows"
    (define (a-frame w h) (frame 0 1 0 1 #:width w #:height h))
    (check-equal? (png-size (saved (list (a-frame 100 80) (a-frame 150 60)) "a.png" #f #f 9))
                  '(250 80))
    (check-equal? (png-size (saved (list (list (a-frame 100 80) (a-frame 150 60))
                                         (list (a-frame 60 70)))
                                   "a.png" #f #f 9))
                  '(250 150)))

  (test-case "formulas as labels are typeset, and kept in files"
    (define (ink label)
      (define f (frame 0 1 0 1 #:x-label label #:width 300 #:height 200))
      (convert (deserialize (serialize f)) 'png-bytes))
    (check-false (equal? (ink 'theta) (ink "theta")))
    (check-false (equal? (ink (g:* 2 'theta)) (ink 'theta)))
    (check-equal? (ink (g:* 2 'theta)) (ink (g:* 2 'theta)))))

(test-case "places in an SVG are in tenths"
  (check-equal? (shortened-svg #"<g><path d=\"M 3.14159 5.04 L -2.96 0.01 L 7.0999 1\"/></g>")
                #"<g><path d=\"M 3.1 5 L -3 0 L 7.1 1\"/></g>"))

(test-case "what is said of figures"
  (check-message (string-append "graphics-save: expected a width in centimeters, from 1 to 200, "
                                "or #f\n  given: the number 0")
                 (graphics-save (drawn) "a.png" #:centimeters 0))
  (check-message (string-append "graphics-save: expected a size of letters in points, from 1 to 100"
                                "\n  given: the number 0.5")
                 (graphics-save (drawn) "a.png" #:font-size 0.5))
  (check-message (string-append "graphics-save: expected the name of a typeface, or #f"
                                "\n  given: the symbol Times")
                 (graphics-save (drawn) "a.png" #:font 'Times))
  (check-exn #rx"expected a frame" (lambda () (graphics-save (list (drawn) 3) "a.png"))))

(test-case "a name that says no format"
  (for ([name '("figure" "figure.gif" "png")])
    (check-message
     (format "graphics-save: the name of the file says no format; it ends in ~a\n  file: ~s"
             ".png, .svg or .pdf" name)
     (graphics-save (drawn) name)))
  (check-exn #rx"expected the name of a file\n  given: the number 3"
             (lambda () (graphics-save (drawn) 3)))
  (check-exn #rx"expected a frame" (lambda () (graphics-save 3 "a.png")))
  (check-exn #rx"frame->pict: .*expected a frame" (lambda () (frame->pict 3))))

;; ---------------------------------------------------------------------------
;; With the drawing library, when it is needed, and without it

(test-case "the drawing library is loaded for the first picture, not before"
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (define (plot name) (dynamic-require 'mechanics/plot name))
    (define (drawing?) (module-declared? 'racket/draw #f))
    (define f ((plot 'frame) 0 1 0 1))
    ((plot 'plot-point) f 0 0)
    ((plot 'plot-function) f sin 0 1 #:color '(200 0 0))
    ((plot 'plot-contours) f * 0.5 #:color 3)
    (check-equal? (format "~a" f)
                  "(frame x from 0.0 to 1.0, y from 0.0 to 1.0: 2 curves, 1 point)")
    (check-false (drawing?))
    (when drawable?
      ((dynamic-require 'file/convertible 'convert) f 'png-bytes)
      (check-true (drawing?)))))

(define remedy
  (string-append
   "\n  pictures are drawn by the libraries Cairo and Pango; to install them:"
   "\n  Debian: apt install libpangocairo-1.0-0 libjpeg62-turbo"
   "\n  Ubuntu: apt install libpangocairo-1.0-0 libjpeg-turbo8"
   "\n  Fedora: dnf install pango libjpeg-turbo; Arch: pacman -S pango libjpeg-turbo"
   "\n  macOS, Windows: Racket's package draw-lib brings them: raco pkg install draw-lib"))

(test-case "frames work where pictures cannot be made, and say so when asked for one"
  (without-drawing
   (lambda (plot convertible)
     (define f ((plot 'frame) 0 1 0 1))
     ((plot 'plot-point) f 0.5 0.5 #:color 'red)
     (check-equal? ((plot 'frame-points) f) '(#(0.5 0.5)))
     (check-equal? ((convertible 'convert) f 'png-bytes) #f)
     (check-equal? ((convertible 'convert) f 'text)
                   "(frame x from 0.0 to 1.0, y from 0.0 to 1.0: 1 point)")
     (check-exn #rx"^frame->pict: pictures cannot be drawn on this machine\n  reason: libcairo"
                (lambda () ((plot 'frame->pict) f)))
     (with-folder (folder)
       (define file (build-path folder "a.png"))
       (define message
         (with-handlers ([exn:fail? exn-message]) ((plot 'graphics-save) f file)))
       (check-equal? message
                     (format "graphics-save: pictures cannot be drawn on this machine\n~a~a~a~a"
                             "  file: " file "\n  reason: libcairo.so.2 is missing" remedy))
       (check-equal? (directory-list folder) '())))
   'mechanics/plot 'file/convertible))
