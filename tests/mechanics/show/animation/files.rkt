#lang racket/base
;; Animations as files: GIFs are parsed, pages are read.

(require json
         (only-in mechanics up down evolve-trajectory coordinate velocity)
         mechanics/animate
         (only-in mechanics/show/animation/on-demand why-no-pictures)
         (only-in pict text)
         racket/file
         racket/list
         racket/port
         racket/string
         xml
         "../../support/checks.rkt"
         "../../support/folder.rkt" "../../support/gif.rkt" "../../support/messages.rkt"
         "../../support/picture-programs.rkt" "../../support/skip.rkt")

(define drawable? (not (why-no-pictures)))
(define no-drawing "the shared libraries of racket/draw are not installed: no files")

;; The bytes of the file that is saved.
(define (saved a extension)
  (with-folder (folder)
    (define file (build-path folder (string-append "motion" extension)))
    (animation-save a file)
    (check-equal? (directory-list folder) (list (string->path (string-append "motion" extension))))
    (file->bytes file)))

(define (round-and-round t) (up t t 1))
(define (turning #:speed [speed 1] #:rate [rate 10] #:to [to 2] #:title [title "Motion"]
                 #:trail-time [trail-time #f] #:portrait [portrait #f])
  (animate round-and-round (draw-pendulum #:width 100) #:from 0 #:to to #:speed speed
           #:frames-per-second rate #:title title #:trail #t #:trail-time trail-time
           #:phase-portrait portrait))

;; ---------------------------------------------------------------------------

(skip-unless drawable? no-drawing

  (test-case "a GIF has the size, the number of pictures and the time that were asked for"
    (define g (parse-gif (saved (turning) ".gif")))
    (check-equal? (gif-size g) '(100 104))
    (check-true (gif-loops? g))
    (check-equal? (length (gif-images g)) 21)
    (check-equal? (remove-duplicates (map gif-image-delay (gif-images g))) '(10)))

  (test-case "a rate that GIFs cannot have is replaced by one near it, at the same speed"
    (define g (parse-gif (saved (turning #:rate 30) ".gif")))
    (check-equal? (remove-duplicates (map gif-image-delay (gif-images g))) '(3))
    (check-= (* 3/100 (- (length (gif-images g)) 1)) 2 3/100)
    (define fast (parse-gif (saved (turning #:rate 100) ".gif")))
    (check-equal? (gif-image-delay (first (gif-images fast))) 2))

  (test-case "pictures after the first are where something changes"
    (define places (map gif-image-place (gif-images (parse-gif (saved (turning) ".gif")))))
    (check-equal? (first places) '(0 0 100 104))
    (for ([place (in-list (rest places))])
      (check-true (< 100 (* (third place) (fourth place)) 5000)))
    (define resting (animate (lambda (t) (up t 0 0)) (draw-pendulum #:width 50) #:from 0 #:to 1
                             #:frames-per-second 4))
    (check-equal? (map gif-image-place (rest (gif-images (parse-gif (saved resting ".gif")))))
                  (make-list 4 '(0 0 1 1)))))

;; ---------------------------------------------------------------------------
;; Pages

(define (page a) (bytes->string/utf-8 (saved a ".html")))

;; The motion that the script plays.
(define (motion page)
  (string->jsexpr
   (cadr (regexp-match #rx"<script id=\"motion\" type=\"application/json\">(.*?)</script>" page))))

(define (without-comments html) (regexp-replace* #px"(?m:^ *//.*$)" html ""))

(skip-unless drawable? no-drawing

  (test-case "a page has all pictures, by numbers of elements that are well-formed"
    (define m (motion (page (turning #:portrait #t))))
    (define elements (hash-ref m 'elements))
    (for ([e (in-list elements)]) (check-pred xexpr? (string->xexpr e)))
    (check-equal? (length (hash-ref m 'panels)) 2)
    (for ([p (in-list (hash-ref m 'panels))])
      (check-equal? (length (hash-ref p 'frames)) 21)
      (for* ([frame (in-list (hash-ref p 'frames))] [k (in-list frame)])
        (check-true (< -1 k (length elements)))))
    (check-equal? (hash-ref m 'times) '(0.0 2.0))
    (check-equal? (hash-ref m 'rate) 10.0))

  (test-case "what rests is there once, what moves is where it moves to"
    (define m (motion (page (turning))))
    (define frames (hash-ref (first (hash-ref m 'panels)) 'frames))
    (check-true (> (length (remove-duplicates (apply append frames))) 4))
    (define-values (first-frame last-frame) (values (first frames) (last frames)))
    (check-true (pair? (filter (lambda (k) (memv k last-frame)) first-frame)))
    (check-true (pair? (filter (lambda (k) (not (memv k last-frame))) first-frame))))

  (test-case "the trail has points between pictures, and as many pictures of it as its time says"
    (define m (motion (page (turning #:trail-time 1))))
    (define trail (first (hash-ref (first (hash-ref m 'panels)) 'trails)))
    (check-equal? (hash-ref m 'detail) 4)
    (check-equal? (length trail) (* 2 (+ 1 (* 4 20))))
    (check-equal? (hash-ref m 'back) 10)
    (check-equal? (hash-ref (motion (page (turning))) 'back) (json-null))
    ;; the bob hangs straight down at first
    (check-equal? (take trail 2) '(50.0 92.0)))

  (test-case "a page asks nothing of the network"
    (define text (page (turning #:portrait #t)))
    (check-false (regexp-match? #rx"https?:|//[a-z]|src=|<link|@import|import ?[(]|fetch|url[(]"
                                (without-comments text)))
    (check-regexp-match #rx"Content-Security-Policy\" content=\"default-src 'none'" text))

  (test-case "the first picture is there without a script, and controls only with one"
    (define text (page (turning)))
    (check-regexp-match #rx"<g id=\"panel0\"><path" text)
    (check-regexp-match #rx"<div class=\"controls\" id=\"controls\" hidden>" text))

  (test-case "no title and no text of a drawing breaks out"
    (define evil "</script><script>alert(1)</script><!--\"'&")
    (define a (animate round-and-round (lambda (s) (text evil)) #:from 0 #:to 1
                       #:frames-per-second 2 #:title evil))
    (define html (page a))
    (check-equal? (length (regexp-match* #rx"<script" html)) 2)
    (check-equal? (length (regexp-match* #rx"</script" html)) 2)
    (check-false (regexp-match? #rx"<!--" html))
    (check-true (string-contains? (second (regexp-match #rx"<title>(.*?)</title>" html))
                                  "&lt;/script&gt;"))
    (check-pred xexpr? (string->xexpr (first (hash-ref (motion html) 'elements))))))

;; ---------------------------------------------------------------------------
;; In a browser, where there is one

(define browser
  (ormap find-executable-path '("chromium" "chromium-browser" "google-chrome")))

;; The document after a script of ours has run on it.
(define (browsed html script)
  (with-folder (folder)
    (define file (build-path folder "page.html"))
    (display-to-file (string-replace html "</body>" (format "<script>~a</script></body>" script))
                     file)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (define-values (process out in err)
        (subprocess #f #f (open-output-file (build-path folder "errors")) browser
                    "--headless" "--no-sandbox" "--disable-gpu" "--dump-dom"
                    (string-append "--user-data-dir=" (path->string (build-path folder "user")))
                    (format "file://~a" file)))
      (close-output-port in)
      (begin0 (port->string out)
              (subprocess-wait process)
              (close-input-port out)))))

(skip-unless (and drawable? browser) "chromium is not installed: pages are not played"
  (test-case "the slider leads to any picture, with its time and its trail"
    (define html (page (turning)))
    (define dom
      (browsed html "const s = document.getElementById('slider');
                     s.value = 15; s.dispatchEvent(new Event('input'));"))
    (check-regexp-match #rx"<output id=\"clock\">t = 1.50</output>" dom)
    (check-regexp-match #rx"<button id=\"play\">Play</button>" dom)
    (define points
      (string-split
       (cadr (regexp-match #rx"<polyline id=\"trail0-0\"[^>]* points=\"([^\"]*)\"" dom))))
    (check-equal? (length points) (* 2 (+ 1 (* 4 15))))
    (define m (motion html))
    (define frame (list-ref (hash-ref (first (hash-ref m 'panels)) 'frames) 15))
    (define shown (cadr (regexp-match #rx"<g id=\"panel0\">(.*?)</g>" dom)))
    (check-equal? (length (regexp-match* #rx"<[a-z]+ " shown)) (length frame)))
  (test-case "it plays at once, and stops when told to"
    (define html (page (turning)))
    (check-regexp-match #rx"<button id=\"play\">Pause</button>" (browsed html ""))
    (check-regexp-match #rx"<button id=\"play\">Play</button>"
                        (browsed html "document.getElementById('play').click();"))))

;; ---------------------------------------------------------------------------
;; Where nothing can be written, nothing is left

(define a (turning))

(test-case "a name that says no format"
  (for ([name '("motion" "motion.png" "gif")])
    (check-message
     (format "animation-save: the name of the file says no format; it ends in ~a\n  file: ~s"
             ".gif or .html" name)
     (animation-save a name)))
  (check-exn #rx"expected the name of a file\n  given: the number 3"
             (lambda () (animation-save a 3)))
  (check-exn #rx"expected an animation" (lambda () (animation-save 3 "a.gif"))))

(skip-unless drawable? no-drawing
  (test-case "a folder that is not there, or is there in place of the file"
    (with-folder (folder)
      (check-exn #rx"^animation-save: there is no such folder\n  file: .*a.gif\n  reason: .*nowhere"
                 (lambda () (animation-save a (build-path folder "nowhere" "a.gif"))))
      (make-directory (build-path folder "b.html"))
      (check-exn #rx"^animation-save: there is a folder of that name\n  file: .*b.html$"
                 (lambda () (animation-save a (build-path folder "b.html"))))
      (check-equal? (directory-list folder) (list (string->path "b.html")))))

  (test-case "a drawing that fails on its way leaves what was there"
    (with-folder (folder)
      (define file (build-path folder "a.gif"))
      (display-to-file "old" file)
      (define (fails s) (if (> (coordinate s) 1) (raise-user-error "broken") (text "x")))
      (define b (animate round-and-round fails #:from 0 #:to 1/2))
      (animation-save b file)
      (display-to-file "old" file #:exists 'truncate)
      (define c (animate (lambda (t) (if (< t 2) (up t t 1) (up t 0 1))) fails #:from 0 #:to 2))
      (check-exn #rx"broken" (lambda () (animation-save c file)))
      (check-equal? (file->string file) "old")
      (check-equal? (directory-list folder) (list (string->path "a.gif")))))

  (test-case "too many pictures are refused before any is drawn"
    (define long (animate round-and-round (draw-pendulum) #:from 0 #:to 1000))
    (with-folder (folder)
      (for ([name '("a.gif" "a.html")])
        (check-message
         (string-append "animation-save: 25001 pictures are too many for a file; at most 3000\n"
                        "  choose fewer #:frames-per-second, a greater #:speed, or a shorter time "
                        "by #:from and #:to")
         (animation-save long (build-path folder name))))
      (check-equal? (directory-list folder) '()))))

;; ---------------------------------------------------------------------------
;; Without the drawing library

(test-case "where pictures cannot be drawn, animations are made, print, and say what is missing"
  (without-drawing
   (lambda (library)
     (define b ((library 'animate) (lambda (t) (vector t t 1)) ((library 'draw-pendulum))
                                   #:from 0 #:to 1))
     (check-equal? (format "~a" b) "(animation from 0 to 1 of (draw-pendulum #:length 1))")
     (check-exn #rx"^animation-frame: pictures cannot be drawn on this machine\n  reason: libcairo"
                (lambda () ((library 'animation-frame) b 0)))
     (check-exn #rx"^draw-pendulum: pictures cannot be drawn on this machine"
                (lambda () (((library 'draw-pendulum)) (vector 0 1 0))))
     (with-folder (folder)
       (check-exn #rx"^animation-save: pictures cannot be drawn on this .*\n  file: .*reason: lib"
                  (lambda () ((library 'animation-save) b (build-path folder "a.gif"))))
       (check-equal? (directory-list folder) '())))
   'mechanics/animate))
