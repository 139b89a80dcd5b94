#lang racket/base
;; Names for the variables of a state that has numbers: those of a program in another language,
;; and of the columns of a table.

(require "../../generic/printed-function.rkt" "../../generic/up-down.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" structure->list))

(provide suggested-names local-state?)

;; Names for the variables of a state whose example is of numbers: t, q and v, or p, for a state
;; (up t q v), numbered where coordinates are several; for any other x with the indices that `ref`
;; takes, as x1_0.
;; clock? : is the rate of the first scalar 1?  -> symbols, one for each scalar
(define (suggested-names derivative example clock?)
  (define parts (if (tuple? example) (structure->list example) (list example)))
  (cond [(and clock? (local-state? parts))
         (append (list 't)
                 (named 'q (cadr parts))
                 (named (if (momenta? derivative (caddr parts)) 'p 'v) (caddr parts)))]
        [else
         (define names (named 'x example))
         (if clock? (cons 't (cdr names)) names)]))

(define (local-state? parts)
  (and (= 3 (length parts))
       (not (tuple? (car parts)))
       (= (shape-length (cadr parts)) (shape-length (caddr parts)))))

;; Momenta are down, and those of Hamilton's equations are no velocities.
(define (momenta? derivative x)
  (or (and (tuple? x) (down? x)) (eq? 'Hamiltonian->state-derivative (made-by derivative))))

;; q; or q0, q1 ..., and q0_1 in tuples of tuples
(define (named letter x)
  (let walk ([name (symbol->string letter)] [x x] [joint ""])
    (if (tuple? x)
        (for*/list ([(e k) (in-indexed (structure->list x))]
                    [all (in-list (walk (format "~a~a~a" name joint k) e "_"))])
          all)
        (list (string->symbol name)))))
