#lang racket/base
;; Frames: what is recorded in them, how they print, when they are closed.

(require file/convertible
         mechanics/plot
         (only-in mechanics/lang/printer install-printer!)
         (only-in racket/port make-pipe-with-specials)
         racket/pretty
         racket/serialize
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (points-of . xys)
  (define f (frame 0 1 0 1))
  (for ([xy (in-list xys)]) (plot-point f (car xy) (cadr xy)))
  (frame-points f))

(define (shown f)
  (list (format "~a" f) (format "~s" f) (format "~v" f) (convert f 'text)))

(define (same text) (list text text text text))

(test-case "a frame prints as its bounds and what is in it"
  (define f (frame 0 2 -1 1))
  (check-equal? (shown f) (same "(frame x from 0.0 to 2.0, y from -1.0 to 1.0: empty)"))
  (plot-point f 1 0)
  (plot-line f 0 0 1 1)
  (plot-function f sin 0 2)
  (check-equal? (shown f)
                (same "(frame x from 0.0 to 2.0, y from -1.0 to 1.0: 1 curve, 1 line, 1 point)"))
  (plot-point f 1 1/2 #:color 'red)
  (plot-line f 0 1 1 0)
  (plot-contours f * '(0.1 0.2))
  (check-equal? (format "~a" f)
                "(frame x from 0.0 to 2.0, y from -1.0 to 1.0: 3 curves, 2 lines, 2 points)")
  (graphics-clear f)
  (check-equal? (format "~a" f) "(frame x from 0.0 to 2.0, y from -1.0 to 1.0: empty)"))

(test-case "an editor that shows pictures is given the frame by the printer of the prompt"
  (define f (frame 0 1 0 1))
  (define-values (in out) (make-pipe-with-specials))
  (parameterize ([current-output-port out]
                 [current-print pretty-print-handler]
                 [pretty-print-size-hook (lambda (x display? port) (and (convertible? x) 1))]
                 [pretty-print-print-hook (lambda (x display? port) (write-special x port))])
    (install-printer!)
    ((current-print) f))
  (check-eq? (read-char-or-special in) f))

(test-case "points are kept as flonums, in their order"
  (check-equal? (points-of '(0 1/2) '(1 0) '(0.25 0.75)) '(#(0.0 0.5) #(1.0 0.0) #(0.25 0.75))))

(test-case "points outside are left out, and those at the edge are not"
  (check-equal? (points-of '(-0.1 0.5) '(0 0) '(1 1) '(1.1 0.5) '(0.5 -1) '(0.5 2))
                '(#(0.0 0.0) #(1.0 1.0))))

(test-case "what is no real number has no place in the plane"
  (check-equal? (points-of '(+nan.0 0.5) '(0.5 +nan.0) '(+inf.0 0.5) '(0.5 -inf.0) '(0.5 +i)) '()))

(test-case "points of many styles are kept apart, and all are there"
  (define f (frame 0 1000 0 1))
  (for ([i (in-range 1000)])
    (plot-point f i 0.5 #:color (modulo i 3)))
  (check-equal? (length (frame-points f)) 1000)
  (check-equal? (sort (map (lambda (p) (vector-ref p 0)) (frame-points f)) <)
                (for/list ([i (in-range 1000)]) (exact->inexact i))))

(test-case "after it is closed, a frame shows what it did and takes nothing more"
  (define f (frame 0 1 0 1))
  (plot-point f 0.5 0.5)
  (graphics-close f)
  (graphics-close f)
  (check-equal? (frame-points f) '(#(0.5 0.5)))
  (for ([draw (list (lambda () (plot-point f 0 0)) (lambda () (plot-line f 0 0 1 1))
                    (lambda () (plot-function f (lambda (x) (error 'f "called")) 0 1))
                    (lambda () (plot-parametric f (lambda (x) (error 'f "called")) 0 1))
                    (lambda () (plot-parametric-fill f (lambda (x) (error 'f "called")) 0 1))
                    (lambda () (plot-contours f (lambda (x y) (error 'f "called")) 0))
                    (lambda () (graphics-clear f)) (lambda () (graphics-show f)))])
    (check-exn #rx"^[a-z-]+: the frame is closed; make a new one to draw in\n  frame: \\(frame x"
               draw)))

(test-case "two threads may draw at once"
  (define f (frame 0 1 0 1))
  (define threads
    (for/list ([color (in-range 4)])
      (thread (lambda ()
                (for ([_ (in-range 5000)])
                  (plot-point f 0.5 0.5 #:color (modulo color 2))
                  (when (zero? (random 500)) (sleep)))))))
  (define reader (thread (lambda () (for ([_ (in-range 50)]) (frame-points f) (sleep)))))
  (for-each thread-wait (cons reader threads))
  (check-equal? (length (frame-points f)) 20000))

(test-case "a break leaves whole lines, and a frame that can be drawn in"
  (define f (frame 0 1 0 1))
  (for ([_ (in-range 20)])
    (define t
      (thread (lambda ()
                (with-handlers ([exn:break? void])
                  (let loop () (plot-line f 0 0 1 1) (loop))))))
    (sleep 0.001)
    (break-thread t)
    (thread-wait t))
  (plot-point f 0 0)
  (check-equal? (length (frame-points f)) 1)
  (for ([c (in-list (frame-curves f))])
    (check-equal? c '(#(0.0 0.0) #(1.0 1.0)))))

(test-case "a frame goes through a file and back, as it was"
  (define f (frame 0 2 -1 1 #:title "title" #:x-label "x" #:width 200 #:aspect-ratio 'equal))
  (plot-point f 1 0.5 #:color 'red #:label "points")
  (plot-function f (lambda (x) (if (= x 1) +nan.0 x)) 0 2 0.5)
  (plot-line f 0 0 1 1 #:style 'dot)
  (plot-contours f * '(0.1 0.2) #:samples 5)
  (define file (open-output-bytes))
  (write (serialize f) file)
  (define description (format "~a" f))
  (define points (frame-points f))
  (define curves (frame-curves f))
  (plot-point f 0 0)
  (define g (deserialize (read (open-input-bytes (get-output-bytes file)))))
  (check-equal? (format "~a" g) description)
  (check-equal? (frame-points g) points)
  (check-equal? (frame-curves g) curves)
  (check-equal? (length (frame-curves g)) 3)
  (plot-point g 1 0.5 #:color 'red #:label "points")
  (check-equal? (length (frame-points g)) 2))

;; Bounds and look are checked.
(says
 [(frame 1 1 0 1) "frame: the least x is not below the greatest\n  least: 1\n  greatest: 1"]
 [(frame 0 1 2 1) "frame: the least y is not below the greatest\n  least: 2\n  greatest: 1"]
 [(frame 0 'a 0 1)
  "frame: expected a real number as greatest x\n  given: the symbol a"]
 [(frame 0 1 -inf.0 1)
  "frame: expected a real number as least y\n  given: the number -inf.0"]
 [(frame 0 1 0 1 #:title 'x)
  "frame: expected a string as title, or #f\n  given: the symbol x"]
 [(frame 0 1 0 1 #:x-label 3)
  "frame: expected a string or a formula, such as 'theta, as label, or #f\n"
  "  given: the number 3"]
 [(frame 0 1 0 1 #:width 1)
  "frame: expected a size of 50 to 10000 pixels\n  given: the number 1"]
 [(frame 0 1 0 1 #:aspect-ratio -1)
  "frame: expected 'equal, a positive ratio of width to height, or #f\n"
  "  given: the number -1"]
 [(graphics-clear 3)
  "graphics-clear: expected a frame, such as (frame 0 1 -1 1)\n  given: the number 3"])
