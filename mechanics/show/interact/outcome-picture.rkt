#lang racket/base
;; The outcome of an interaction at some values of its controls, as a picture: frames and picts as
;; they are, formulas typeset, all else as text.

(require file/convertible
         (only-in racket/draw read-bitmap)
         (only-in racket/string string-split)
         (only-in pict bitmap blank colorize inset pict->bitmap pict? pict-height pict-width scale
                  text vl-append)
         "outcome.rkt"
         (only-in "../animation/pict-recorder.rkt" record-pict)
         (only-in "../animation/svg.rkt" image-element)
         "../display/filled-lines.rkt" "../display/result.rkt"
         "../plot/frame.rkt" "../plot/frame-output.rkt")

(provide loaded? convert-drawn outcome->pict drawn-elements)

;; To call it loads this file, and those it requires.
(define (loaded?) #t)

(define columns 72)

;; request : as `convert` names it, 'png-bytes and so on
(define (convert-drawn o request default)
  (define x (if (failed? o) o (as-convertible o)))
  (cond [(convertible? x) (convert x request default)]
        [else
         (define-values (picture grows?) (outcome->pict o))
         (convert picture request default)]))

;; A formula becomes a value of which there is a picture.
(define (as-convertible x) (if (convertible? x) x (simplified-result x columns 'picture)))

;; -> a pict, and may it be enlarged?  What cannot be drawn is told.
(define (outcome->pict o)
  (cond [(failed? o) (values (written-red (failed-text o)) #f)]
        [else
         (define x (as-convertible o))
         (define picture (and (convertible? x) (not (drawn? x)) (bitmap-of x)))
         (cond [(frame? x) (values (inset (frame->pict x) 4) #t)]
               [(pict? x) (values x #t)]
               [picture (values picture #f)]
               [else (values (written (string-split (format "~v" x) "\n" #:trim? #f)) #f)])]))

(define (drawn? x) (or (frame? x) (pict? x)))

;; A line drawing -> its width, its height and its elements (animation/svg.rkt) in a list;
;; or #f.  Of many points an image has fewer bytes.
(define (drawn-elements x)
  (define picture (and (drawn? x) (if (frame? x) (frame->pict x) x)))
  (define (elements)
    (if (and (frame? x) (> (length (frame-points x)) many-points))
        (list (as-image picture))
        (record-pict picture)))
  (and picture (list (pict-width picture) (pict-height picture) (elements))))

(define many-points 1000)

(define (as-image picture)
  (image-element (pict->bitmap picture) 0 0 (pict-width picture) (pict-height picture)
                 1 (vector 1 0 0 1 0 0)))

;; As the value itself draws itself, twice as fine if it can; #f if it does not.
(define (bitmap-of x)
  (define fine (convert x 'png@2x-bytes #f))
  (define coarse (if fine #f (convert x 'png-bytes #f)))
  (cond [fine (inset (scale (png->pict fine) 1/2) margin)]
        [coarse (png->pict coarse)]
        [else #f]))

(define (png->pict bytes) (bitmap (read-bitmap (open-input-bytes bytes) 'png/alpha)))

(define margin 10)

(define (written lines)
  (define (line l) (if (string=? l "") (blank 1 12) (text l 'modern 12)))
  (inset (apply vl-append 2 (map line lines)) margin))

(define (written-red words)
  (define lines
    (for*/list ([paragraph (in-list (string-split words "\n"))]
                [line (in-list (filled (string-split paragraph " " #:trim? #f) columns))])
      line))
  (colorize (written lines) "firebrick"))
