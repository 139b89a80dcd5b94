#lang racket/base
;; The kinds of exercise: what an answer is a function of, how it is written, and whether the
;; verdict on it shows the key.
;;
;; How each is judged stands in judge.rkt.

(require "answer-data.rkt" "exercise.rkt" "prescribed-symbols.rkt")

(provide (struct-out kind) kinds kind-of-exercise rounds-of answer-form answer-of-kind)

;; arguments : what an answer is applied to, one of none, time, path, local, state, named
;; says      : what an answer is, in words
;; open?     : is a refutation no news about the key?  So it is where the question itself says
;;             how an answer is judged
;; key?      : must the worksheet have the right answer?
(struct kind (name arguments says open? key?))

(define kinds
  (list
   (kind 'expression 'named "An expression" #f #t)
   (kind 'number 'none "A number" #f #t)
   (kind 'Lagrangian 'local "A Lagrangian" #f #t)
   (kind 'equations 'path "What is zero along a motion" #f #t)
   (kind 'solution 'time "A path" #t #t)
   (kind 'conserved 'local "A quantity" #t #t)
   (kind 'function 'local "A function" #f #t)
   (kind 'constraint-force 'local "A force" #f #t)
   (kind 'Hamiltonian 'state "A Hamiltonian" #f #t)
   (kind 'canonical 'state "A map of states" #t #t)
   (kind 'reason 'none "A sentence or two, in quotation marks" #t #f)
   (kind 'expects 'named "A value" #t #f)))

(define (find-kind name)
  (for/first ([k (in-list kinds)] #:when (eq? name (kind-name k))) k))

(define (kind-of-exercise e) (find-kind (exercise-kind e)))

;; What an answer is a function of; a clause may say otherwise.
(define (arguments-of e)
  (define usual (kind-arguments (kind-of-exercise e)))
  (define named (setting e 'arguments '()))
  (cond [(pair? named) 'named]
        [(eq? usual 'named) 'none]
        [(and (eq? usual 'local) (setting e 'Hamiltonian)) 'state]
        [else usual]))

;; The arguments of each application: ((path) (t)) for what is applied to a path, and its value
;; to the time.
(define (rounds-of e)
  (define names (exercise-coordinates e))
  (case (arguments-of e)
    [(none) '()]
    [(time) '((t))]
    [(path) (list (list (path-of names)) '(t))]
    [(local) (list (list (local-tuple-of names)))]
    [(state) (list (list (state-of names)))]
    [(named) (list (setting e 'arguments))]))

;; x : what was answered, a value -> data
(define (answer-of-kind e x)
  (if (eq? 'reason (exercise-kind e))
      (text-answer->datum x)
      (answer->datum x (rounds-of e))))

;; How the definition of an answer begins.
(define (answer-form e)
  (define name (exercise-name e))
  (define names (exercise-coordinates e))
  (define (listed names) (if (null? (cdr names)) (car names) (cons 'up names)))
  (case (arguments-of e)
    [(none) (format "(define ~a ~a)" name (if (eq? (exercise-kind e) 'reason) "\"...\"" "..."))]
    [(time) (format "(define (~a t) ...)" name)]
    [(path) (format "(define ((~a ~a) t) ...)" name (listed names))]
    [(local) (format "(define (~a ~s) ...)" name `(up t ,(listed names) ,(listed (dotted names))))]
    [(state) (format "(define (~a ~s) ...)" name
                     `(up t ,(listed names) ,(momenta-pattern names)))]
    [(named) (format "(define ~s ...)" (cons name (setting e 'arguments)))]))

(define (dotted names)
  (for/list ([n (in-list names)]) (string->symbol (format "~adot" n))))

(define (momenta-pattern names)
  (define ps (for/list ([n (in-list names)]) (string->symbol (format "p_~a" n))))
  (if (null? (cdr ps)) (car ps) (cons 'down ps)))
