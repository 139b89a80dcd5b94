#lang racket/base
;; A coordinate in place of the time (SICM 5.6, pp. 402–407).
;;
;; Where H(q, p) = E does not depend on the time, a coordinate x = q^k may count in its place: the
;; others, as functions of x, move by Hamilton's equations with the negative of the momentum
;;
;;     H_r(x, q_r, p_r) = −(the p_k with H = E).
;;
;; What is left is the shape of the orbit.  Of two such momenta the greater one is taken, that of
;; motion forwards where the kinetic energy is a square; or, asked for, the lesser.

(require "momentum-by-energy.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/symbols-like.rkt")

(provide reduced-Hamiltonian state->reduced-state)

;; k : the index of the coordinate;  ((reduced-Hamiltonian H k E) (up x q_r p_r)) = −p_k
(define-plain (reduced-Hamiltonian H k E #:backwards? [backwards? #f])
  (define who 'reduced-Hamiltonian)
  (check-Hamiltonian who H)
  (check-index who k)
  (define degree-at (settled-by-shape (lambda (state) (degree-of who H k state))))
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
    (unless (and (tuple? q) (> (structure-length (adopt q)) (max k 1)))
      (complain who "there is no coordinate of index ~a beside others; given ~a" k
                (describe-with-value state)))
    (up (s:ref q k) (without q k list->up) (without (momentum state) k list->down))))

;; One of a single other coordinate is the number itself.
(define (without x k make)
  (define rest (for/list ([e (in-list (structure->list x))] [i (in-naturals)]
                          #:unless (= i k))
                 e))
  (if (null? (cdr rest)) (car rest) (make rest)))

;; p_k ↦ H, in the reduced state
(define ((energy-by-momentum H k state) p)
  (H (up 0
         (with-inserted (coordinate state) k (time state) list->up)
         (with-inserted (momentum state) k p list->down))))

(define (with-inserted rest k x make)
  (define others (if (tuple? rest) (structure->list rest) (list rest)))
  (make (let insert ([k k] [others others])
          (if (= k 0) (cons x others) (cons (car others) (insert (sub1 k) (cdr others)))))))

;; ---------------------------------------------------------------------------
;; Of what degree is H in the momentum?  Asked once for states of a shape, at symbols.

(define (settled-by-shape find)
  (define known #f)             ; a state and what was found
  (lambda (state)
    (unless (and known (same-shape? (car known) state))
      (set! known (cons state (find state))))
    (cdr known)))

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
  (define-values (t p) (values (string->uninterned-symbol "t") (string->uninterned-symbol "p")))
  (define e
    (simplify (H (up t (with-inserted (coordinate place) k (time place) list->up)
                     (with-inserted (momentum place) k p list->down)))))
  (when (and (expression? e) (occurs? t e))
    (complain who
              (string-append "~a depends on the time; extended-Hamiltonian makes the time "
                             "a coordinate first")
              (value->text H))))

;; ---------------------------------------------------------------------------
;; What is given

(define (check-index who k)
  (unless (exact-nonnegative-integer? k)
    (complain-of-argument who "the index of a coordinate" k)))

(define (check-place who k state)
  (define n (if (tuple? (coordinate state)) (structure-length (adopt (coordinate state))) 1))
  (when (> k n)
    (complain who
              (string-append "the reduced state (up x q p) has ~a ~a beside the one of index ~a, "
                             "which comes from a state of more; given ~a")
              n (if (= n 1) "coordinate" "coordinates") k (describe-with-value state))))
