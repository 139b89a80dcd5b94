#lang racket/base
;; S-expressions as trees: the printed form of an expression, an operator or a relation, in the
;; notation of a physics book.

(require "formula-style.rkt" "name.rkt" "numeral.rkt" "tree.rkt" "tree-arithmetic.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt" "../expression/write.rkt")

(provide datum->tree plain-datum->tree (struct-out way) current-way)

;; How a datum is to be written.
;; dots?     : (datum of the argument -> boolean) are derivatives with respect to it marked by
;;             dots?
;; hidden    : symbols; arguments that consist of them are not shown
;; commuting?: may factors be ordered?
(struct way (dots? hidden commuting?) #:authentic)

;; drawn? : is the formula drawn, and not on one line?
(define (current-way drawn? commuting?)
  (define style (derivative-style))
  (way (lambda (argument)
         (or (eq? style 'dots) (and (eq? style 'automatic) drawn? (eq? argument 't))))
       (suppress-arguments)
       commuting?))

;; In the order in which it is written, and drawn.
(define (plain-datum->tree d) (datum->tree d (current-way #t #f)))

;; Trees may stand in the datum for themselves.
(define (datum->tree d w)
  (define known (make-hasheq))
  (define (tree d)
    (cond [(pair? d)
           (hash-ref! known d
                      (lambda () (if (list? d) (form d w tree) (plain (format "~s" d)))))]
          [(number? d) (number->tree d)]
          [(symbol? d) (symbol->tree d w)]
          [(or (string? d) (keyword? d) (boolean? d) (null? d)) (plain (format "~s" d))]
          [(omission? d) (omitted (format "~a" d))]
          [(prefab-struct-key d) d]                ; a tree
          [else (plain (format "~a" d))]))
  (tree (cut-datum d)))

(define (symbol->tree s w)
  (cond [(eq? s '<function>) (plain "<function>")]
        [(and (not (way-commuting? w)) (known-function? s)) (hash-ref known-functions s)]
        [(pi-alias? s)
         (product-of (list (number->tree (pi-multiple s)) (name exact-pi)) #t)]
        [else (name s)]))

;; ---------------------------------------------------------------------------
;; Forms

(define (form d w tree)
  (define head (car d))
  (define arguments (cdr d))
  (cond [(and (symbol? head) (hash-ref makers head #f))
         => (lambda (make) (or (make (map tree arguments) w) (application-form d w tree)))]
        [(matrix-rows d) => (lambda (rows) (grid (map (lambda (row) (map tree row)) rows)))]
        [(marks-of d) => (lambda (marks) (derivative marks #f))]
        [(and (marks-of head) (= 1 (length arguments)))
         (derivative (marks-of head) (as-operand (tree (car arguments))))]
        [else (application-form d w tree)]))

;; The rows of (matrix-by-rows (list a ...) ...), or #f
(define (matrix-rows d)
  (and (eq? (car d) 'matrix-by-rows)
       (pair? (cdr d))
       (andmap (lambda (row) (and (list? row) (pair? row) (eq? (car row) 'list))) (cdr d))
       (map cdr (cdr d))))

(define (application-form d w tree)
  (define head (car d))
  (define arguments (cdr d))
  (cond [(and (pair? arguments) (hidden? arguments w) (not (known-function? head)))
         (function-of head arguments w tree)]
        [(known-function? head) (known-application head (map tree arguments))]
        [else (application (as-function (function-of head arguments w tree))
                           (map tree arguments) #f)]))

(define (hidden? arguments w)
  (andmap (lambda (a) (and (symbol? a) (memq a (way-hidden w)))) arguments))

;; The function at the head of an application, dotted where that is the way.
(define (function-of head arguments w tree)
  (define order (dots-of head))
  (if (and order (= 1 (length arguments)) ((way-dots? w) (car arguments)))
      (dotted (tree (cadr head)) order)
      (tree head)))

;; ---------------------------------------------------------------------------
;; Functions whose meaning is known

(define known-functions
  (for/hasheq ([f (in-list written-names)]
               #:unless (memq f '(+ - * / expt sqrt abs exp)))
    (values f (word (symbol->string f)))))

(define (known-function? head) (and (symbol? head) (hash-has-key? known-functions head)))

(define (known-application head arguments)
  (application (hash-ref known-functions head) arguments
               (and (= 1 (length arguments)) (simple? (car arguments)))))

;; May it follow a function without parentheses?
(define (simple? t) (or (and (name? t) (short-name? t)) (digits? t)))

;; ---------------------------------------------------------------------------
;; Forms with a notation of their own: (trees way -> tree), #f where it does not apply

(define ((taking n make) ts w) (and (= n (length ts)) (apply make ts)))

(define ((chain sign) ts w)
  (and (>= (length ts) 2)
       (for/fold ([left (car ts)]) ([right (in-list (cdr ts))]) (relation left sign right))))

(define (adjective sign) (taking 1 (lambda (t) (relation t sign (digits "0")))))

(define (minus ts w)
  (cond [(null? ts) #f]
        [(null? (cdr ts)) (negated (car ts))]
        [else (difference-of (car ts) (cdr ts))]))

(define (over ts w)
  (cond [(null? ts) #f]
        [(null? (cdr ts)) (quotient-of (digits "1") (car ts))]
        [else (for/fold ([t (car ts)]) ([below (in-list (cdr ts))]) (quotient-of t below))]))

(define makers
  (hasheq '+ (lambda (ts w) (and (pair? ts) (sum-of ts)))
          '- minus
          '* (lambda (ts w) (and (pair? ts) (product-of ts (way-commuting? w))))
          '/ over
          'expt (taking 2 power-of)
          'square (taking 1 (lambda (t) (power-of t (digits "2"))))
          'cube (taking 1 (lambda (t) (power-of t (digits "3"))))
          'sqrt (taking 1 radical)
          'abs (taking 1 bars)
          'exp (taking 1 exponential)
          'up (lambda (ts w) (column ts))
          'down (lambda (ts w) (across ts))
          'list (lambda (ts w) (listing ts))
          '= (chain "=") '< (chain "<") '> (chain ">") '<= (chain "≤") '>= (chain "≥")
          'positive (adjective ">") 'negative (adjective "<")
          'nonnegative (adjective "≥") 'nonpositive (adjective "≤")
          'compose (chain "∘")))

;; ---------------------------------------------------------------------------
;; Marks of derivatives: D, (partial 1 0), (expt D 2), (* (partial 0) (partial 1))

;; The marks that a datum stands for, or #f.
(define (marks-of d)
  (cond [(eq? d 'D) (list (mark #f 1))]
        [(not (and (list? d) (pair? d))) #f]
        [else
         (case (car d)
           [(partial) (and (pair? (cdr d))
                           (andmap exact-nonnegative-integer? (cdr d))
                           (list (mark (cdr d) 1)))]
           [(expt) (and (= 3 (length d))
                        (exact-positive-integer? (caddr d))
                        (repeated (marks-of (cadr d)) (caddr d)))]
           [(*) (let ([all (map marks-of (cdr d))])
                  (and (pair? all) (andmap values all) (apply append all)))]
           [else #f])]))

;; A single mark, n times; #f of several marks.
(define (repeated marks n)
  (and marks
       (null? (cdr marks))
       (list (mark (mark-path (car marks)) (* n (mark-count (car marks)))))))

;; The number of dots, up to 3, for which a head such as ((expt D 2) x) asks, or #f: the
;; function has a short name without dots of its own.
(define (dots-of head)
  (define marks (and (list? head) (= 2 (length head)) (symbol? (cadr head)) (marks-of (car head))))
  (and marks
       (null? (cdr marks))
       (not (mark-path (car marks)))
       (<= (mark-count (car marks)) 3)
       (memq (parts-sort (name-parts (cadr head))) '(letter capital))
       (= 0 (parts-dots (name-parts (cadr head))))
       (mark-count (car marks))))

;; Is it one letter, with whatever stands around it?
(define (short-name? t) (memq (parts-sort (name-parts (name-symbol t))) '(letter capital word)))
