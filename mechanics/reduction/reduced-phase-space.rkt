#lang racket/base
;; A coordinate in place of the time (SICM 5.6, pp. 402–407).
;;
;; Where H(q, p) = E does not depend on the time, a coordinate x = q^k may count in its place: the
;; others, as functions of x, move by Hamilton's equations with the negative of the momentum
;;
;;     H_r(x, q_r, p_r) = −(the p_k with H = E).
;;
;; The shape of the orbit is left.  Of two such momenta the greater one is taken, that of
;; motion forwards where the kinetic energy is a square; or, asked for, the lesser.

(require (only-in racket/list split-at)
         "momentum-by-energy.rkt"
         "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/structure.rkt")

(provide reduced-Hamiltonian state->reduced-state)

;; k : the index of the coordinate;  ((reduced-Hamiltonian H k E) (up x q_r p_r)) = −p_k
(define-plain (reduced-Hamiltonian H k E #:backwards? [backwards? #f])
  (define who 'reduced-Hamiltonian)
  (check-Hamiltonian who H)
  (check-index who k)
  (define degree-at (by-shape (lambda (state) (degree-of who H k state))))
  (unary-function (lambda () (list who (value->datum H) k (value->datum E))) (state)
    (check-H-state who state)
    (check-place who k state)
    (g:negate (momentum-by-energy (energy-by-momentum H k state) (degree-at state) E
                                  (if backwards? -1 1)))))

;; (t, q, p) ↦ (q^k, q_r, p_r)
(define (state->reduced-state k)
  (define who 'state->reduced-state)
  (check-index who k)
  (unary-function (lambda () (list who k)) (state)
    (check-H-state who state)
    (define q (coordinate state))
    (unless (and (tuple? q) (> (s:length q) (max k 1)))
      (complain who "there is no coordinate of index ~a beside others; given ~a" k
                (describe-with-value state)))
    (up (s:ref q k) (without q k list->up) (without (momentum state) k list->down))))

;; The tuple x without component k; a single other component is no tuple.
(define (without x k make)
  (define-values (before after) (split-at (structure->list x) k))
  (single-or make (append before (cdr after))))

;; p_k ↦ H, in the reduced state
(define ((energy-by-momentum H k state [t 0]) p)
  (H (up t
         (with-inserted (coordinate state) k (time state) list->up)
         (with-inserted (momentum state) k p list->down))))

(define (with-inserted rest k x make)
  (define-values (before after)
    (split-at (if (tuple? rest) (structure->list rest) (list rest)) k))
  (make (append before (cons x after))))

;; ---------------------------------------------------------------------------
;; The degree of H in the momentum, found once for states of a shape, at symbols

(define (degree-of who H k state)
  (define place (symbols-like state "x"))
  (check-time-free who H k place)
  (define degree
    (degree-in (energy-by-momentum H k place) (string->uninterned-symbol "p")))
  (case degree
    [(1 2) degree]
    [(0) (complain who "~a does not depend on the momentum of index ~a, which it cannot give"
                   (value->text H) k)]
    [else (complain who
                    "the momentum of index ~a is found where ~a is of degree 1 or 2 in it" k
                    (value->text H))]))

(define (check-time-free who H k place)
  (define t (string->uninterned-symbol "t"))
  (define H-of-momentum (energy-by-momentum H k place t))
  (when (occurs? t (simplify (H-of-momentum (string->uninterned-symbol "p"))))
    (complain who
              (string-append "~a depends on the time; extended-Hamiltonian makes the time "
                             "a coordinate first")
              (value->text H))))

;; ---------------------------------------------------------------------------
;; The arguments

(define (check-index who k)
  (check-argument who exact-nonnegative-integer? k "the index of a coordinate"))

(define (check-place who k state)
  (define n (s:length (coordinate state)))
  (when (> k n)
    (complain who
              (string-append "the reduced state (up x q p) has ~a ~a beside the one of index ~a, "
                             "which comes from a state of more; given ~a")
              n (if (= n 1) "coordinate" "coordinates") k (describe-with-value state))))
