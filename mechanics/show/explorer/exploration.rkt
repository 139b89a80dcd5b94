#lang racket/base
;; The state of an exploration of a map: its orbits, the part of the plane on view, and the steps
;; that can be undone.  It knows no window.

(require racket/flonum
         "../../error/message-words.rkt"
         "orbit-worker.rkt" "../plot/pixels.rkt" "../plot/points.rkt")

(provide make-exploration exploration-bounds exploration-orbits exploration-map exploration-n
         traced-orbit traced-count exploration->dots for-each-orbit exploration->text
         add-orbit! add-points! zoom! whole! clear! undo!
         each-orbit-marked)

;; bounds : the view; whole : the first view; orbits : the latest first; past : procedures that
;; restore the earlier states, the latest first
(struct exploration (map n whole [bounds #:mutable] [orbits #:mutable] [past #:mutable])
  #:authentic)

;; An orbit with the points received from the worker.
(struct traced (orbit points) #:authentic)

;; The number of points of a traced orbit.
(define (traced-count t) (snapshot-count (take-snapshot (traced-points t))))

;; "2 orbits, 2002 points"
(define (exploration->text e)
  (define orbits (exploration-orbits e))
  (format "~a, ~a" (counted (length orbits) "orbit")
          (counted (for/sum ([t (in-list orbits)]) (traced-count t)) "point")))

;; (visit color x y) for each point, orbit by orbit
(define (exploration->dots e visit)
  (for-each-orbit e
    (lambda (color xs ys count)
      (for ([x (in-flvector xs 0 count)] [y (in-flvector ys 0 count)]) (visit color x y)))))

;; (visit color xs ys count), the earliest first; the first `count` of both flvectors are points
(define (for-each-orbit e visit)
  (for ([t (in-list (reverse (exploration-orbits e)))])
    (define s (take-snapshot (traced-points t)))
    (visit (orbit-color (traced-orbit t)) (snapshot-xs s) (snapshot-ys s) (snapshot-count s))))

(define (make-exploration map n bounds) (exploration map n bounds bounds '() '()))

(define (next-color e)
  (define orbits (exploration-orbits e))
  (if (null? orbits) 0 (+ 1 (orbit-color (traced-orbit (car orbits))))))

(define (remember! e)
  (define-values (bounds orbits) (values (exploration-bounds e) (exploration-orbits e)))
  (define (bring-back)
    (for ([t (in-list (exploration-orbits e))] #:unless (memq t orbits))
      (stop-orbit! (traced-orbit t)))
    (set-exploration-bounds! e bounds)
    (set-exploration-orbits! e orbits))
  (set-exploration-past! e (cons bring-back (exploration-past e))))

(define (add-orbit! e x y)
  (define o (make-orbit (next-color e) x y))
  (remember! e)
  (set-exploration-orbits! e (cons (traced o (make-points)) (exploration-orbits e)))
  o)

;; -> #f if the orbit has been removed meanwhile
(define (add-points! e o xs ys count)
  (define t (findf (lambda (t) (eq? o (traced-orbit t))) (exploration-orbits e)))
  (when t
    (for ([x (in-flvector xs 0 count)] [y (in-flvector ys 0 count)])
      (add-point! (traced-points t) x y)))
  (and t #t))

(define (zoom! e bounds)
  (remember! e)
  (set-exploration-bounds! e bounds))

(define (whole! e)
  (unless (equal? (exploration-bounds e) (exploration-whole e)) (zoom! e (exploration-whole e))))

(define (clear! e)
  (remember! e)
  (for ([t (in-list (exploration-orbits e))]) (stop-orbit! (traced-orbit t)))
  (set-exploration-orbits! e '()))

;; Undoes the last step that has not been undone yet.
(define (undo! e)
  (unless (null? (exploration-past e))
    (define bring-back (car (exploration-past e)))
    (set-exploration-past! e (cdr (exploration-past e)))
    (bring-back)))

;; Marks all orbits on the pixels p.  color->bytes : number -> three bytes
(define (each-orbit-marked e p color->bytes)
  (for-each-orbit e (lambda (color xs ys count) (mark! p xs ys count (color->bytes color)))))
