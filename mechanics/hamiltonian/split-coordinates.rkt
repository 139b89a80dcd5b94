#lang racket/base
;; Coordinates in two parts, as Routhians have them: of q = (q⁰ … qⁿ⁻¹), y are the coordinates at
;; chosen places and x the others, each part in the order of q; a part of one is no tuple.
;;
;; A function of (t, q, v) is then one of (t, (x, y), (vx, vy)).

(require racket/list
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt"
         (only-in "../value/structure.rkt" list->up s:length structure->list))

(provide check-places in-two-parts parted-state joined-state)

;; places : an index, or a list of them; #f where coordinates are given in two parts already
;; -> a list of indices, or #f
(define (check-places who places)
  (define all (if (exact-nonnegative-integer? places) (list places) places))
  (unless (or (not all)
              (and (pair? all) (list? all) (andmap exact-nonnegative-integer? all)
                   (not (check-duplicates all))))
    (complain who
              (string-append "#:momenta names coordinates by their places, "
                             "as 1 or '(1 2), each once\n  given: ~a")
              (value->text places)))
  all)

;; L of local tuples, as a function of those with two parts
(define (in-two-parts who L places)
  (if places
      (unary-function (lambda () (value->datum L)) (local) (L (joined-state who local places)))
      L))

;; (t, q, v) -> (t, (x, y), (vx, vy))
(define (parted-state who local places)
  (unless (and (local-tuple? local) (= (s:length local) 3)
               (up? (coordinate local)) (up? (velocity local)))
    (complain who "expected coordinates and velocities in tuples, (up t (up q ...) (up v ...))~a"
              (format "\n  given: ~a" (value->text local))))
  (define (part q) (parted who (structure->list q) places))
  (up (time local) (part (coordinate local)) (part (velocity local))))

(define (parted who qs places)
  (define n (length qs))
  (check-inside who places n)
  (define others (remove* places (range n)))
  (define (those indices)
    (single-or list->up (for/list ([i (in-list indices)]) (list-ref qs i))))
  (up (those others) (those (sort places <))))

;; (t, (x, y), (vx, vy)) -> (t, q, v)
(define (joined-state who local places)
  (define y-alone? (null? (cdr places)))
  (define (join parts)
    (define-values (x y) (apply values (structure->list parts)))
    (joined who x (if y-alone? (list y) (structure->list y)) places))
  (up (time local) (join (coordinate local)) (join (velocity local))))

;; x : a tuple of several coordinates, or one coordinate alone, which may be a tuple of one
(define (joined who x ys places)
  (define xs (if (and (up? x) (> (s:length x) 1)) (structure->list x) (list x)))
  (define n (+ (length xs) (length ys)))
  (check-inside who places n)
  (unless (= (length ys) (length places))
    (complain who "~a coordinates have momenta; the state has ~a in its second part"
              (length places) (length ys)))
  (define place-of (for/hash ([p (in-list (sort places <))] [y (in-list ys)]) (values p y)))
  (for/fold ([found '()] [rest xs] #:result (list->up (reverse found))) ([i (in-range n)])
    (if (hash-has-key? place-of i)
        (values (cons (hash-ref place-of i) found) rest)
        (values (cons (car rest) found) (cdr rest)))))

(define (check-inside who places n)
  (for ([p (in-list places)] #:unless (< p n))
    (complain who "there is no coordinate ~a to have a momentum; there are ~a, from 0 on" p n))
  (when (= (length places) n)
    (complain who
              (string-append "a Routhian keeps the velocity of one coordinate at least"
                             "\n  with momenta for all it is a Hamiltonian: "
                             "(Lagrangian->Hamiltonian L)"))))
