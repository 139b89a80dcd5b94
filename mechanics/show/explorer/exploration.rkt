#lang racket/base
;; What has been explored of a map: its orbits, the part of the plane that is shown, and what was
;; done, so that it can be undone.  No window yet.

(require racket/flonum
         "../plot/orbit-worker.rkt" "../plot/pixels.rkt" "../plot/points.rkt")

(provide make-exploration exploration-bounds exploration-orbits exploration-map exploration-n
         traced-orbit traced-count exploration->dots
         add-orbit! add-points! zoom! whole! clear! undo!
         next-color each-orbit-marked)

;; bounds : what is shown; whole : what was shown first; orbits : latest first; past : what
;; brings back each earlier state, latest first
(struct exploration (map n whole [bounds #:mutable] [orbits #:mutable] [past #:mutable])
  #:authentic)

;; An orbit with the points received of it.
(struct traced (orbit points) #:authentic)

;; How many points of it there are.
(define (traced-count t) (snapshot-count (take-snapshot (traced-points t))))

;; (visit color x y) for each point, orbit by orbit
(define (exploration->dots e visit)
  (for ([t (in-list (reverse (exploration-orbits e)))])
    (define s (take-snapshot (traced-points t)))
    (define color (orbit-color (traced-orbit t)))
    (for ([k (in-range (snapshot-count s))])
      (visit color (flvector-ref (snapshot-xs s) k) (flvector-ref (snapshot-ys s) k)))))

(define (make-exploration map n bounds) (exploration map n bounds bounds '() '()))

(define (next-color e)
  (for/fold ([next 0]) ([t (in-list (exploration-orbits e))])
    (max next (+ 1 (orbit-color (traced-orbit t))))))

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

;; -> is the orbit still there?
(define (add-points! e o xs ys count)
  (define t (for/first ([t (in-list (exploration-orbits e))] #:when (eq? o (traced-orbit t))) t))
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

;; The last of these that has not been undone yet.
(define (undo! e)
  (unless (null? (exploration-past e))
    (define bring-back (car (exploration-past e)))
    (set-exploration-past! e (cdr (exploration-past e)))
    (bring-back)))

;; All again, on pixels of another part of the plane.  color->bytes : number -> three bytes
(define (each-orbit-marked e p color->bytes)
  (for ([t (in-list (reverse (exploration-orbits e)))])
    (define s (take-snapshot (traced-points t)))
    (mark! p (snapshot-xs s) (snapshot-ys s) 0 (snapshot-count s)
           (color->bytes (orbit-color (traced-orbit t))))))
