#lang racket/base
;; Coordinates in two parts, as Routhians have them: of q = (q⁰ … qⁿ⁻¹), y are those at chosen
;; places and x the others, each part in the order of q, one alone without a tuple.
;;
;; A function of (t, q, v) is then one of (t, (x, y), (vx, vy)).

(require racket/list
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt")

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
  (unless (and (local-tuple? local) (= (vector-length (tuple-elements local)) 3)
               (up? (coordinate local)) (up? (velocity local)))
    (complain who "expected coordinates and velocities in tuples, (up t (up q ...) (up v ...))~a"
              (format "\n  given: ~a" (value->text local))))
  (define (part q) (parted who (tuple->list q) places))
  (up (time local) (part (coordinate local)) (part (velocity local))))

(define (parted who qs places)
  (define n (length qs))
  (check-inside who places n)
  (define others (remove* places (range n)))
  (define (those indices) (alone-or-up (for/list ([i (in-list indices)]) (list-ref qs i))))
  (up (those others) (those (sort places <))))

;; (t, (x, y), (vx, vy)) -> (t, q, v)
(define (joined-state who local places)
  (define y-alone? (null? (cdr places)))
  (define (join parts)
    (define-values (x y) (apply values (tuple->list parts)))
    (joined who x (if y-alone? (list y) (tuple->list y)) places))
  (up (time local) (join (coordinate local)) (join (velocity local))))

;; How many there are in x the tuple tells, but for one alone.
(define (joined who x ys places)
  (define xs (if (and (up? x) (> (vector-length (tuple-elements x)) 1)) (tuple->list x) (list x)))
  (define n (+ (length xs) (length ys)))
  (check-inside who places n)
  (unless (= (length ys) (length places))
    (complain who "~a coordinates have momenta; the state has ~a in its second part"
              (length places) (length ys)))
  (define place-of (for/hash ([p (in-list (sort places <))] [y (in-list ys)]) (values p y)))
  (define-values (all _rest)
    (for/fold ([found '()] [rest xs]) ([i (in-range n)])
      (if (hash-has-key? place-of i)
          (values (cons (hash-ref place-of i) found) rest)
          (values (cons (car rest) found) (cdr rest)))))
  (apply up (reverse all)))

(define (check-inside who places n)
  (for ([p (in-list places)] #:unless (< p n))
    (complain who "there is no coordinate ~a to have a momentum; there are ~a, from 0 on" p n))
  (when (= (length places) n)
    (complain who
              (string-append "a Routhian keeps the velocity of one coordinate at least"
                             "\n  with momenta for all it is a Hamiltonian: "
                             "(Lagrangian->Hamiltonian L)"))))

(define (alone-or-up xs) (if (null? (cdr xs)) (car xs) (apply up xs)))
(define (tuple->list x) (vector->list (tuple-elements x)))
