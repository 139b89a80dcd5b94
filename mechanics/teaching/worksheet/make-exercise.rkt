#lang racket/base
;; Exercises made of their clauses, as a teacher writes them.
;;
;; The value of a clause is applied to the symbols of the exercise's kind, as an answer is, and
;; kept as data.

(require racket/list
         "answer-data.rkt" (only-in "answer-parts.rkt" same?)
         "exercise-kind.rkt" "exercise.rkt"
         "prescribed-symbols.rkt" "question-names.rkt"
         "../../error/complain.rkt" "../../error/spelling.rkt"
         "../../generic/describe.rkt"
         "../../lagrangian/Lagrange-equations.rkt"
         "../../value/read-expression.rkt")

(provide make-exercise)

;; clauses : lists of the name of a clause and its arguments
(define (make-exercise name kind question clauses)
  (check-clauses name kind question clauses)
  (define (has? clause) (and (assq clause clauses) #t))
  (define (argument clause [otherwise #f])
    (if (has? clause) (car (rest-of clause clauses)) otherwise))
  (define (of-each clause make)
    (for/list ([c (in-list clauses)] #:when (eq? (car c) clause)) (make (cdr c))))
  (define names (rest-of 'coordinates clauses))
  (define draft
    (exercise name kind question names
              (settings name names clauses argument)
              #f (argument 'points 1) '()
              (of-each 'hint (lambda (parts) (make-hint name parts)))
              (not (or (has? 'no-practice) (eq? kind 'expects)))))
  (define key-value (if (has? 'key) (argument 'key) (usual-key draft argument)))
  (define rounds (rounds-of draft))
  (define key (and key-value (clause-datum name 'key key-value rounds)))
  (when (eq? kind 'canonical) (check-moves-something name key names))
  (struct-copy exercise draft
               [key key]
               [settings (with-names draft key)]
               [slips (of-each 'slip (lambda (parts) (make-slip name parts rounds)))]))

;; The settings, with the names of which the question speaks.
(define (with-names e key)
  (define all (exercise-settings e))
  (define (given name) (let ([d (setting e name)]) (if d (list d) '())))
  (define-values (constants functions)
    (names-in-question (append (if key (list key) '()) (setting e 'besides '())
                               (append-map given '(system force becomes starts)))
                       (exercise-coordinates e) (setting e 'arguments '())))
  (define (also all name found) (if (null? found) all (hash-set all name found)))
  (also (also all 'names constants) 'functions functions))

;; A Lagrangian determines its equations of motion.
(define (usual-key e argument)
  (and (eq? (exercise-kind e) 'equations) (argument 'of) (Lagrange-equations (argument 'of))))

(define (rest-of name clauses)
  (define c (assq name clauses))
  (if c (cdr c) '()))

;; ---------------------------------------------------------------------------
;; Clauses

(define (settings name names clauses argument)
  (define Hamiltonian (argument 'of-Hamiltonian))
  (define (datum clause x . rounds) (and x (clause-datum name clause x rounds)))
  (define (at-state x)
    (and x (datum 'of x (list ((if Hamiltonian state-of local-tuple-of) names)))))
  (define K (argument 'becomes))
  (define all
    (hasheq 'system (at-state (or Hamiltonian (argument 'of)))
            'Hamiltonian (and Hamiltonian #t)
            'force (at-state (argument 'force))
            'becomes (and K (datum 'becomes K (list (state-of names))))
            'besides (map at-state (rest-of 'besides clauses))
            'starts (datum 'starts (argument 'starts))
            'arguments (rest-of 'arguments clauses)
            'constants (rest-of 'constants clauses)
            'assuming (rest-of 'assuming clauses)
            'within (argument 'within)
            'absolute (memq '#:absolute (rest-of 'within clauses))
            'unit (argument 'unit)
            'credit (make-credit name (rest-of 'credit clauses))
            'check (argument 'expects)))
  (for/hasheq ([(key x) (in-hash all)] #:unless (memv x '(#f ()))) (values key x)))

(define (clause-datum name clause x rounds)
  (define d (answer->datum x rounds))
  (unless (eq? (car d) 'answer)
    (complain name "the clause `~a` is of no use: ~a" clause
              (case (car d)
                [(text) "it is a text; only students may answer with formulas as on paper"]
                [(failed) (cadr d)]
                [else "it has no value"])))
  (cadr d))

;; -> hasheq: the share of the points for an answer with the slip sign or factor
(define (make-credit name parts)
  (and (pair? parts)
       (for/hasheq ([keyword (in-list '(#:sign #:factor))] [sort (in-list '(sign factor))])
         (define share (keyword-value parts keyword 0))
         (check-share name share)
         (values sort share))))

(define (check-share name share)
  (unless (and (real? share) (<= 0 share 1))
    (complain name "the credit of a slip is a share of the points, from 0 to 1\n  given: ~a"
              (value->text share))))

(define (make-slip name parts rounds)
  (unless (and (>= (length parts) 2) (string? (cadr parts)))
    (complain name "a slip is a wrong answer and what to say of it, (slip answer \"...\")"))
  (define credit (keyword-value parts '#:credit 0))
  (check-share name credit)
  (slip (clause-datum name 'slip (car parts) rounds) (cadr parts) credit))

(define (make-hint name parts)
  (unless (and (pair? parts) (string? (car parts)))
    (complain name "a hint is a text, (hint \"...\") or (hint \"...\" #:after 2)"))
  (define after (keyword-value parts '#:after 1))
  (unless (exact-nonnegative-integer? after)
    (complain name "a hint comes after a number of wrong answers, as in #:after 2\n  given: ~a"
              (value->text after)))
  (hint (car parts) after))

(define (keyword-value parts keyword otherwise)
  (define found (memq keyword parts))
  (if (and found (pair? (cdr found))) (cadr found) otherwise))

;; ---------------------------------------------------------------------------
;; Complaints

(define several-times '(hint slip))

(define (check-clauses name kind question clauses)
  (define k (find-kind kind))
  (define (has? clause) (assq clause clauses))
  (unless (string? question)
    (complain name "the question is a text, behind the kind of the exercise\n  given: ~a"
              (value->text question)))
  (unless k
    (complain name "there is no kind of exercise called ~a~a" kind
              (among kind (map kind-name kinds))))
  (when (eq? name 'unanswered)
    (complain name "that name stands for what is not answered yet; call the exercise otherwise"))
  (define twice (check-duplicates (remq* several-times (map car clauses))))
  (when twice (complain name "the clause `~a` stands there twice" twice))
  (check-needed name k has?)
  (check-numbers name clauses))

(define (check-needed name k has?)
  (define (need clause why) (unless (has? clause) (complain name "~a" why)))
  (when (memq (kind-arguments k) '(path local state time))
    (need 'coordinates "it needs the names of the coordinates, as in (coordinates theta)"))
  (when (and (memq (kind-name k) '(solution conserved)) (not (has? 'of-Hamiltonian)))
    (need 'of "it needs the system, as in (of L) for a Lagrangian L"))
  (when (and (has? 'becomes) (not (has? 'of-Hamiltonian)))
    (complain name "with (becomes K) it needs the Hamiltonian, as in (of-Hamiltonian H)"))
  (when (and (has? 'within) (not (memq (kind-name k) measured)))
    (complain name (string-append "the clause `within` is for numbers, and for expressions and "
                                  "functions with decimals; an answer of the kind ~a is proved")
              (kind-name k)))
  (when (eq? (kind-name k) 'expects)
    (need 'expects "it needs the procedure that judges, as in (expects (lambda (answer) ...))"))
  (when (and (kind-key? k) (not (and (eq? (kind-name k) 'equations) (has? 'of))))
    (need 'key "it has no key, as in (key (sqrt (/ 'g 'l)))")))

;; The kinds in which decimals are compared
(define measured '(number expression function constraint-force phase-function))

;; The identity would be called trivial, had a student answered with it.
(define (check-moves-something name key names)
  (when (same? (read-expression key) (state-of names))
    (complain name (string-append "the key is the identity, which leaves every state where it "
                                  "is: a canonical map is wanted that is not trivial"))))

(define (check-numbers name clauses)
  (for ([c (in-list clauses)])
    (define given (if (pair? (cdr c)) (cadr c) '()))
    (define (check good? text . parts)
      (unless good?
        (complain name "~a\n  given: ~a" (apply format text parts) (value->text given))))
    (case (car c)
      [(points within)
       (check (and (real? given) (>= given 0))
              "the clause `~a` takes a number that is not negative" (car c))])
    (case (car c)
      [(within)
       (check (or (< given 1) (memq '#:absolute (cdr c)))
              (string-append "the clause `within` takes a share of the key's value, as 1/100, or "
                             "an error in the unit, (within 5 #:absolute)"))]
      [(unit) (check (string? given) "the unit is a text, as in (unit \"s\")")])))
