#lang racket/base
;; Answers that are texts, as they stand on paper: "m*(1 + 4*a^2*r^2)*r'' + 8 m a^2 r r'^2".
;;
;; The exercise decides the meaning of names: its coordinates with their rates and
;; momenta, the constants of its key, the functions there.  So the answer is in the symbols to which
;; answers of its kind are applied (prescribed-symbols.rkt).

(require (only-in racket/list append-map flatten index-of last remove-duplicates)
         (only-in racket/string string-trim)
         "exercise.rkt" "exercise-kind.rkt" "prescribed-symbols.rkt"
         "../../algebra/notation/formula.rkt" "../../algebra/notation/handwritten-formula.rkt"
         "../../algebra/notation/infix.rkt"
         (only-in "../../algebra/notation/one-line-name.rkt" line-name->symbol)
         (only-in "../../generic/describe.rkt" value->datum) "../../generic/notation.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" ref))

(provide read-written-answer formula-read reading-of (struct-out formula-as-read))

;; -> an answer as data (answer-data.rkt): (answer datum) or (failed "why")
(define (read-written-answer e text)
  (define names (exercise-coordinates e))
  (let/ec return
    (define (refuse why) (return (list 'failed why)))
    (define (unclear a b)
      (refuse (format "it has two readings, ~a and ~a: parentheses or a sign * tell which is meant"
                      (formula-read names a) (formula-read names b))))
    (define entries
      (read-handwritten (without-unit e text) (vocabulary-of e) refuse unclear))
    (define d (with-numbers (answer-of-entries e entries refuse) (numbers-by-name e)))
    (list 'answer (with-orientation d (expected-shape e)))))

;; The numbers that the worksheet gives, but for names that stand for anything in the question
(define (numbers-by-name e)
  (define asked (append (setting e 'names '()) (setting e 'constants '()) (setting e 'arguments '())
                        (exercise-coordinates e)))
  (filter (lambda (n) (not (memq (car n) asked))) (setting e 'given-numbers '())))

(define (with-numbers d table)
  (cond [(pair? d) (cons (car d) (map (lambda (part) (with-numbers part table)) (cdr d)))]
        [(assq d table) => cdr]
        [else d]))

(define (without-unit e text)
  (define unit (setting e 'unit))
  (define plain (string-trim text))
  (define with-unit (format "^(.*[0-9)}])[ ]*~a$" (regexp-quote (or unit ""))))
  (define m (and unit (regexp-match (regexp with-unit) plain)))
  (if m (cadr m) plain))

;; d : an answer as data -> the formula on paper that was read, as data to be shown; or (unread)
(define (reading-of e d)
  (define found
    (if (and (eq? 'text (car d)) (not (eq? 'reason (exercise-kind e))))
        (read-written-answer e (cadr d))
        '(unread)))
  (if (eq? 'answer (car found))
      (list 'answer (with-dots (cadr found) (exercise-coordinates e)))
      '(unread)))

;; A formula as it was read, to be shown: typeset where that can be done
(struct formula-as-read (datum)
  #:property prop:notation (lambda (x see) (tree:datum (formula-as-read-datum x)))
  #:property prop:custom-write
  (lambda (x port mode) (write-string (formula-read '() (formula-as-read-datum x)) port)))

;; names : coordinates -> "m ẍ + k x", the formula as read, on one line
(define (formula-read names datum)
  (tree->line (datum->tree (with-dots datum names) (current-way #f #f))))

;; The printer knows xdotdot as ẍ.
(define (with-dots d names)
  (define accelerations (map (lambda (n) (rate-symbol n 2 names)) names))
  (let walk ([d d])
    (cond [(pair? d) (map walk d)]
          [(memq d accelerations)
           (string->symbol (format "~adotdot" (list-ref names (index-of accelerations d))))]
          [else d])))

;; ---------------------------------------------------------------------------
;; Equations, lists

;; entries : the sides of each relation
(define (answer-of-entries e entries refuse)
  (define (value-of sides refuse)
    (case (exercise-kind e)
      [(equations) (residual (remove-duplicates sides) refuse)]
      [(conserved) (right-side (moving-sides e sides) refuse)]
      [else (right-side sides refuse)]))
  (define values (for/list ([sides (in-list entries)]) (value-of sides refuse)))
  (define whole (if (null? (cdr values)) (car values) (cons 'up values)))
  (let walk ([d whole])
    (cond [(not (pair? d)) d]
          [(eq? '= (car d)) (walk (value-of (cdr d) refuse))]
          [else (map walk d)])))

(define (residual sides refuse)
  (case (length sides)
    [(1) (car sides)]
    [(2) (if (eqv? 0 (cadr sides)) (car sides) (list '- (car sides) (cadr sides)))]
    [else (refuse "there are several = in one equation")]))

;; Of E = ... = const the side that varies with the state, if it is one alone
(define (moving-sides e sides)
  (define names (moving-names (exercise-coordinates e)))
  (define moving
    (for/list ([s (in-list sides)] #:when (ormap (lambda (d) (memq d names)) (flatten s))) s))
  (if (= 1 (length moving)) moving sides))

;; Of L = ..., x(t) = ... the right side
(define (right-side sides refuse)
  (define left (car sides))
  (unless (or (null? (cdr sides)) (symbol? left)
              (and (pair? left) (symbol? (car left)) (not (memq (car left) signs))))
    (refuse "it is an equation where an expression is expected"))
  (last sides))

(define signs '(+ - * / expt =))

;; ---------------------------------------------------------------------------
;; Up and down, of which paper knows nothing

;; -> a datum of the shape that an answer has, or #f
(define (expected-shape e)
  (case (exercise-kind e)
    [(canonical) (value->datum (state-of (exercise-coordinates e)))]
    [(equations) #f]
    [else (exercise-key e)]))

(define (with-orientation d shape)
  (define (tuple-datum? x) (and (pair? x) (memq (car x) '(up down))))
  (if (and (tuple-datum? d) (tuple-datum? shape) (= (length d) (length shape)))
      (cons (car shape) (map with-orientation (cdr d) (cdr shape)))
      d))

;; ---------------------------------------------------------------------------
;; Names

(define (vocabulary-of e)
  (define names (exercise-coordinates e))
  (define table (known-names e))
  (vocabulary line-name->symbol
              (lambda (s) (hash-ref table s #f))
              (lambda (s) (and (memq s (append '(up down) (setting e 'functions '()))) #t))
              (lambda (s dots)
                (define n (and (<= dots 2) (hash-ref table s #f)))
                (and (memq n names) (rate-symbol n dots names)))
              (lambda (d) (and (memq d (moving-names names)) #t))))

(define (moving-names names)
  (if (null? names) '() (remq 't (scalars (long-tuple-of names)))))

(define (rate-symbol name dots names)
  (list-ref (scalars (ref (long-tuple-of names) (+ 1 dots))) (index-of names name)))

;; -> symbol as it may be written -> symbol of the answer
(define (known-names e)
  (define names (exercise-coordinates e))
  (define arguments (arguments-of e))
  (define own
    (append (setting e 'names '()) (setting e 'constants '()) (setting e 'arguments '())
            (map car (numbers-by-name e))
            (if (eq? arguments 'none) '() '(t))
            (if (memq arguments '(path local state)) names '())))
  (define table (make-hasheq (map (lambda (s) (cons s s)) own)))
  (define (also! s meaning) (unless (hash-has-key? table s) (hash-set! table s meaning)))
  (also! ':pi ':pi)
  (when (eq? arguments 'state)
    (for ([p (in-list (momenta-of names))]) (also! p p))
    (when (null? (cdr names)) (also! 'p (car (momenta-of names)))))
  (when (memq arguments '(path local))
    (for* ([n (in-list names)] [dots '(1 2)] [s (in-list (dotted-spellings n dots))])
      (also! s (rate-symbol n dots names))))
  (for* ([(s meaning) (in-hash (hash-copy table))] [other (in-list (index-spellings s))])
    (also! other meaning))
  table)

;; thetadot, theta_dot; of x_1 also xdot_1
(define (dotted-spellings name dots)
  (define text (symbol->string name))
  (define m (regexp-match #rx"^([^_]*)(_.*)$" text))
  (define (spellings dot)
    (append (list (string-append text dot) (string-append text "_" dot))
            (if m (list (string-append (cadr m) dot (caddr m))) '())))
  (map string->symbol
       (append-map spellings (if (= dots 1) '("dot") '("ddot" "dotdot")))))

;; x_1 and x1 are the same.
(define (index-spellings s)
  (define m (regexp-match #px"^([^0-9_]+)(_?)([0-9]+)$" (symbol->string s)))
  (if m
      (list (string->symbol (string-append (cadr m) (if (string=? "" (caddr m)) "_" "")
                                           (cadddr m))))
      '()))
