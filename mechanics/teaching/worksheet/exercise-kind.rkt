#lang racket/base
;; The kinds of exercise: the arguments of an answer, how it is written, and whether the verdict
;; on it shows the key.
;;
;; judge.rkt tells how each is judged.

(require "answer-data.rkt" "exercise.rkt" "prescribed-symbols.rkt"
         (only-in "../../error/message-words.rkt" joined))

(provide (struct-out kind) kinds find-kind kind-of-exercise arguments-of rounds-of answer-form
         answer-names answer-of-kind velocity-told)

;; arguments : of an answer, one of none, time, path, local, state, named
;; says      : an answer of the kind, in words
;; open?     : does a refutation tell nothing about the key, since the question itself says how an
;;             answer is judged?
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
   (kind 'phase-function 'state "A function of the state" #f #t)
   (kind 'canonical 'state "A map of states" #t #t)
   (kind 'reason 'none "A sentence or two, in quotation marks" #t #f)
   (kind 'expects 'named "A value" #t #f)))

;; -> kind, or #f
(define (find-kind name) (findf (lambda (k) (eq? name (kind-name k))) kinds))

(define (kind-of-exercise e) (find-kind (exercise-kind e)))

;; The arguments of an answer; a clause overrides its kind.
(define (arguments-of e)
  (define usual (kind-arguments (kind-of-exercise e)))
  (define named (setting e 'arguments '()))
  (cond [(pair? named) 'named]
        [(eq? usual 'named) 'none]
        [(and (eq? usual 'local) (setting e 'Hamiltonian)) 'state]
        [else usual]))

;; The arguments of each application: ((path) (t)) for a function of a path whose value is a
;; function of the time.
(define (rounds-of e)
  (define names (exercise-coordinates e))
  (case (arguments-of e)
    [(none) '()]
    [(time) '((t))]
    [(path) (list (list (path-of names)) '(t))]
    [(local) (list (list (local-tuple-of names)))]
    [(state) (list (list (state-of names)))]
    [(named) (list (setting e 'arguments))]))

;; x : the answer, a value -> data
(define (answer-of-kind e x)
  (if (eq? 'reason (exercise-kind e))
      (text-answer->datum x)
      (answer->datum x (rounds-of e))))

;; The beginning of an answer's definition.
(define (answer-form e)
  (define name (exercise-name e))
  (define names (exercise-coordinates e))
  (define (listed names [head 'up]) (as-one names (lambda (names) (cons head names))))
  (case (arguments-of e)
    [(none) (format "(define ~a ~a)" name (if (eq? (exercise-kind e) 'reason) "\"...\"" "..."))]
    [(time) (format "(define (~a t) ...)" name)]
    [(path) (format "(define ((~a ~a) t) ...)" name (listed names))]
    [(local) (format "(define (~a ~s) ...)" name `(up t ,(listed names) ,(listed (dotted names))))]
    [(state) (format "(define (~a ~s) ...)" name
                     `(up t ,(listed names) ,(listed (momenta-of names) 'down)))]
    [(named) (format "(define ~s ...)" (cons name (setting e 'arguments)))]))

;; Names that an answer may have besides, and that it may be a text; or #f
(define (answer-names e)
  (define names (append (setting e 'names '()) (setting e 'functions '())))
  (define all (filter pair? (list (map symbol->string names) (motion-names e))))
  (and (not (eq? 'reason (exercise-kind e)))
       (string-append "or as on paper, in quotation marks"
                      (if (null? all) "" ". Names in it: ")
                      (joined (map (lambda (part) (joined part ", ")) all) "; "))))

;; How a motion is written on paper -> strings: the coordinate x, its velocity x'
(define (motion-names e)
  (define names (exercise-coordinates e))
  (define (said whose noun nouns names)
    (format "~a ~a ~a" whose (if (null? (cdr names)) noun nouns)
            (joined (map symbol->string names) ", ")))
  (define (of-each . words)
    (apply said (if (null? (cdr names)) "its" "their") words))
  (define (velocities) (of-each "velocity" "velocities" (primed names "'")))
  (define (motion . rest) (cons (said "the" "coordinate" "coordinates" names) rest))
  (case (arguments-of e)
    [(local) (motion (velocities))]
    [(path) (motion (velocities) (of-each "acceleration" "accelerations" (primed names "''")))]
    [(state) (motion (of-each "momentum" "momenta" (momenta-of names)))]
    [else '()]))

;; Words about a v in an answer where velocities have other names; or #f
(define (velocity-told e)
  (define names (exercise-coordinates e))
  (and (memq (arguments-of e) '(path local))
       (format "the ~a ~a" (if (null? (cdr names)) "velocity is" "velocities are")
               (joined (map symbol->string (primed names "'")) ", "))))

(define (primed names primes)
  (for/list ([n (in-list names)]) (string->symbol (format "~a~a" n primes))))

(define (dotted names)
  (for/list ([n (in-list names)]) (string->symbol (format "~adot" n))))
