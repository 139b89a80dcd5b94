#lang racket/base
;; Orbits drawn without a screen.

(require mechanics
         mechanics/book
         mechanics/plot
         (only-in mechanics/error/progress current-reporter reporter)
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define (section) (frame 0 :2pi 0 :2pi))
(define T (standard-map 0.6))
(define (points f) (map vector->list (frame-points f)))

(test-case "the start and n images of it, as the map gives them; the frame is returned"
  (define win (section))
  (check-eq? (explore-map win T 10 #:starts (list (up 1 1))) win)
  (check-equal? (length (points win)) 11)
  (check-close (list-ref (points win) 0) '(1 1) 1e-15)
  (check-close (list-ref (points win) 10) '(2.02201816481268 1.33373402711283) 1e-13))

(test-case "no image at all: the start alone"
  (define win (section))
  (explore-map win T 0 #:starts (list (up 1 1)))
  (check-equal? (points win) '((1.0 1.0))))

(test-case "several orbits, points as tuples or pairs, each orbit in a colour of its own"
  (define win (section))
  (explore-map win T 5 #:starts (list (up 1 1) (cons 2 3)))
  (check-equal? (length (points win)) 12)
  (define other (section))
  (display-map other T 2 3 5)
  (check-equal? (points other) (list-tail (points win) 6)))

(test-case "the first orbit may have another colour; a saved exploration is drawn again so"
  (define win (section))
  (explore-map win T 5 #:starts (list (up 1 1)) #:color 3)
  (check-equal? (length (points win)) 6))

(test-case "a grid starts in the middle of equal parts of the frame"
  (define win (frame 0 4 0 2))
  (define (stay x y return fail) (return x y))
  (explore-map win stay 1 #:grid '(2 1))
  (check-equal? (points win) '((1.0 1.0) (1.0 1.0) (3.0 1.0) (3.0 1.0))))

(test-case "an orbit ends where there is no image; starts of a grid without one are left out"
  (define (down x y return fail) (if (> y 0) (return x (- y 1)) (fail)))
  (define win (frame -1 1 -5 5))
  (explore-map win down 100 #:starts (list (up 0 2.5)))
  (check-equal? (points win) '((0.0 2.5) (0.0 1.5) (0.0 0.5) (0.0 -0.5)))
  (graphics-clear win)
  (explore-map win down 100 #:grid '(1 2))
  (check-equal? (length (points win)) 4))

(test-case "points that leave for ever end an orbit, too"
  (define win (frame -1 1 -1 1))
  (explore-map win (Henon-map 1.32) 100000 #:starts (list (up 0 0.1) (up 0.9 30)))
  (check-true (andmap (lambda (p) (< (abs (car p)) 1)) (points win))))

(test-case "word of progress: of each orbit the start and the images; at the end all are drawn"
  (define-values (port now) (values (open-output-string) 0))
  (define (clock) (set! now (+ now 5000)) now)
  (parameterize ([current-reporter (reporter port clock)])
    (explore-map (section) T 2 #:starts (list (up 1 1) (up 2 3))))
  (check-equal? (regexp-match* #rx"\r([^\e]*)\e" (get-output-string port) #:match-select cadr)
                (append (for/list ([k (in-range 1 7)]) (format "explore-map: ~a of 6 points" k))
                        '(""))))

(define win (section))
(define (nowhere x y return fail) (fail))

;; The section of Hénon and Heiles at E = 1/8.
(test-case "a start outside the surface: the interval that its energy allows is told"
  (define star (frame -0.5 0.7 -0.6 0.6))
  (define message
    (with-handlers ([exn:fail:contract? exn-message])
      (explore-map star (HHmap 1/8 0.1 1e-10 1e-12) 10 #:starts (list (up -0.48 0)))))
  (define found
    (regexp-match #rx"for the ordinate 0.0 it has images of abscissas from (.*) to (.*)$" message))
  (check-close (map string->number (cdr found)) '(-0.4396926208 0.6736481777) 1e-6))

;; Maps that do not end as a map should.
(define (silent x y return fail) (list (+ x y) y))
(define (bare x y return fail) (if (= x 1) (fail) (list x y)))
(define (doubtful x y return fail) (return x y) (fail))
(define (hurried x y return fail) (return x y) 'done)
(define (crowded x y return fail) (return x y 1))
(define (worded x y return fail) (return x 'y))
(define (explained x y return fail) (fail "outside"))
(define (later x y return fail) (if (> x 3) (list x y) (return (+ x 1) y)))
(define (broken x y return fail) (error 'broken "no such place"))

(test-case "what the map itself raises reaches the reader"
  (check-exn #rx"^broken: no such place$"
             (lambda () (explore-map win broken 10 #:starts (list (up 1 2))))))

(says
 [(explore-map win silent 10 #:starts (list (up 1 2)))
  "explore-map: the map calls neither `return` nor `fail`\n  map: silent\n"
  "  point: (up 1.0 2.0)\n  value: (3.0 2.0)\n"
  "  the image goes to the third argument: (return x y)"]
 [(explore-map win bare 10 #:starts (list (up 1 2)))
  "explore-map: the map calls neither `return` nor `fail`\n  map: bare\n"
  "  point: (up 0.0 2.0)\n  value: (0.0 2.0)\n"
  "  the image goes to the third argument: (return x y)"]
 [(explore-map win doubtful 10 #:starts (list (up 1 2)))
  "explore-map: the map calls `return` or `fail` more than once for one point\n"
  "  map: doubtful\n  point: (up 1.0 2.0)"]
 [(explore-map win hurried 10 #:starts (list (up 1 2)))
  "explore-map: the map goes on after it has called `return` or `fail`; what these give is to "
  "be its value\n  map: hurried\n  point: (up 1.0 2.0)"]
 [(explore-map win crowded 10 #:starts (list (up 1 2)))
  "explore-map: the map calls `return` with other things than the coordinates of an image\n"
  "  map: crowded\n  point: (up 1.0 2.0)\n  given: 1.0, 2.0, 1"]
 [(explore-map win worded 10 #:starts (list (up 1 2)))
  "explore-map: the map calls `return` with other things than the coordinates of an image\n"
  "  map: worded\n  point: (up 1.0 2.0)\n  given: 1.0, y"]
 [(explore-map win explained 10 #:starts (list (up 1 2)))
  "explore-map: the map calls `fail` with arguments; it takes none\n"
  "  map: explained\n  point: (up 1.0 2.0)\n  given: \"outside\""]
 [(explore-map win later 10 #:starts (list (up 1 2)))
  "explore-map: the map calls neither `return` nor `fail`\n  map: later\n"
  "  point: (up 4.0 2.0)\n  value: (4.0 2.0)\n"
  "  the image goes to the third argument: (return x y)"])

(says
 [(explore-map win nowhere 10 #:starts (list (up 1 2)))
  "explore-map: the map has no image of the start (up 1.0 2.0)\n  map: nowhere\n"
  "  in the frame it has none for the ordinate 2.0"]
 [(explore-map win T 10 #:starts 3)
  "explore-map: #:starts is a list of points to start at; given the number 3"]
 [(explore-map win T 10 #:starts '(3))
  "explore-map: start 0 is no point of the plane, such as (up x y) or (cons x y)\n"
  "  given: the number 3"]
 [(explore-map win T -1 #:starts '())
  "explore-map: expected how many points an orbit has, a natural number\n"
  "  given: the number -1"]
 [(explore-map win T 1 #:starts '() #:color -1)
  "explore-map: expected a small natural number as the first color\n"
  "  given: the number -1"]
 [(explore-map win T 1 #:grid 5)
  "explore-map: #:grid is a list of two numbers of starts, across and up; given the number 5"]
 [(explore-map win sin 1 #:grid '(5 5))
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `sin`, which takes 1 argument"])

;; ---------------------------------------------------------------------------
;; Collectors

(test-case "the default collector shows what explore-map shows, and hands on the last point"
  (define-values (by-n by-collector) (values (section) (section)))
  (explore-map by-n T 10 #:starts (list (up 1 1)))
  (define collect (default-collector (default-monitor by-collector) T 10))
  (check-eq? (explore-map by-collector collect #f #:starts (list (up 1 1))) by-collector)
  (check-equal? (points by-collector) (points by-n))
  (check-equal? (collect 1 1 list void) (list-ref (points by-n) 10)))

(test-case "a collector of what is no number; and where there is no image"
  (define seen '())
  (define (grow word k return fail)
    (if (< k 3) (return (string-append word "a") (+ k 1)) (fail)))
  (define collect (default-collector (lambda (w k) (set! seen (cons w seen))) grow 2))
  (check-equal? (collect "" 0 list void) '("aa" 2))
  (check-equal? (reverse seen) '("" "a" "aa"))
  (check-equal? (collect "" 2 list (lambda () 'none)) 'none))

(test-case "starts of a grid without an image are left out by a collector, too"
  (define win (frame -1 1 -1 1))
  (define (right x y return fail) (if (> x 0) (return x y) (fail)))
  (define (collect x y done fail)
    (right x y (lambda (x y) (plot-point win x y) (done x y)) fail))
  (explore-map win collect #f #:grid '(4 1))
  (check-equal? (length (points win)) 2))

(says
 [(explore-map win (default-collector void T 10) #f)
  "explore-map: a collector follows its orbits by itself, from starts that are given, not in a "
  "window\n  (explore-map f collector #f #:starts (list (up x y) ...)), or #:grid (list 5 5)"]
 [(explore-map win (default-collector void nowhere 10) #f #:starts (list (up 1 2)))
  "explore-map: the map has no image of a point that is needed\n"
  "  map: <function>\n  point: (up 1.0 2.0)"]
 [((default-collector 3 T 10) 1 1 list void)
  "default-collector: what shows points is a procedure of two coordinates; given the number 3"]
 [((default-collector void sin 10) 1 1 list void)
  "default-collector: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `sin`, which takes 1 argument"]
 [((default-collector void T -1) 1 1 list void)
  "default-collector: expected how many images are followed, a natural "
  "number\n  given: the number -1"])
