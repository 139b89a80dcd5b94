#lang racket/base
;; Formulas as people and programs write them: what the prompt offers is right in value, or
;; nothing is offered.  The judge shares nothing with the reader of formulas.

(require mechanics/lang/paper-notation/line-habits
         mechanics/lang/paper-notation/prefix-form
         mechanics/lang/prompt/typed-forms
         mechanics/lang/unknown-name/known-name
         mechanics/lang/unknown-name/suggestion
         racket/list
         racket/math
         racket/runtime-path
         "../../support/checks.rkt")

(define-runtime-path table "formulas.rktd")

(define space (make-base-namespace))
(parameterize ([current-namespace space]) (namespace-require 'mechanics))

;; ---------------------------------------------------------------------------
;; Offers

(define leads
  (string-append "(?:operations come first: | is written |of [(]up t q [vp][)]: |a product is |"
                 "in parentheses: )"))

;; text : typed at the prompt -> the datum that is offered in its place, or #f
(define (offer text)
  (define advice (parameterize ([current-namespace space]) (advice-on-line text)))
  (define found (and advice (regexp-match-positions* (pregexp leads) advice)))
  (define code
    (and (pair? found)
         (not (regexp-match? #rx"operations come first, as in" advice))
         (read (open-input-string (substring advice (cdr (last found)))))))
  (and (not (keyword? code)) (not (and (pair? code) (memq '... code))) code))

(define (advice-on-line text)
  (define forms (with-handlers ([exn:fail:read? (lambda (e) '())]) (forms-in text)))
  (define alone? (and (pair? forms) (null? (cdr forms))))
  (or (and (pair? forms) (meant-as-one forms known-name? function-name?))
      (and alone? (identifier? (car forms))
           (suggestion (syntax-e (car forms)) (namespace-mapped-symbols)))))

;; The same in a row of operands, as in (1/2 * m * v^2) within a program
(define (offer-of-row text)
  (define forms (with-handlers ([exn:fail:read? (lambda (e) '())]) (forms-in text)))
  (and (pair? forms) (pair? (cdr forms)) (prefix-form forms)))

;; ---------------------------------------------------------------------------
;; The judge

;; Names that are spelled in several ways
(define spellings
  (hash 'θ 'theta 'ω 'omega 'φ 'phi 'γ 'gamma 'α 'alpha 'β 'beta 'π 'pi 'x₁ 'x_1 'x₂ 'x_2))

(define (value d point)
  (let value ([d d])
    (cond [(number? d) d]
          [(symbol? d)
           (define s (hash-ref spellings d d))
           (if (eq? s 'pi) pi (number-for (list point s)))]
          [(eq? (car d) 'quote) (value (cadr d))]
          [(and (symbol? (car d)) (hash-ref operations (car d) #f))
           => (lambda (f) (apply f (map value (cdr d))))]
          [else (for/fold ([sum (value (if (pair? (car d)) (cons 'head (car d)) (car d)))])
                          ([a (in-list (cdr d))] [k (in-naturals 2)])
                  (+ sum (* (sqrt k) (value a))))])))

;; Of either sign, never small
(define (number-for key)
  (define n (modulo (equal-hash-code (format "~s" key)) 100003))
  (* (if (odd? n) -1 1) (+ 0.3 (* 3e-5 n))))

(define (relation . xs) (for/fold ([sum 0.7]) ([x (in-list xs)]) (- (* 1.3 x) sum)))

(define operations
  (hash '+ + '- - '* * '/ / 'expt expt 'sqrt sqrt 'sin sin 'cos cos 'tan tan 'exp exp 'log log
        'abs (lambda (x) (if (real? x) (abs x) (magnitude x)))
        'asin asin 'acos acos 'atan atan 'square sqr 'cube (lambda (x) (* x x x))
        '< relation '= (lambda xs (+ 5 (apply relation xs)))))

;; Definitions by their names, their last arguments and their bodies
(define (same? d right)
  (define (defines? d) (and (pair? d) (eq? (car d) 'define)))
  (cond [(and (defines? d) (defines? right))
         (and (same-head? (cadr d) (cadr right))
              (same-value? (last d) (last right)))]
        [(and (pair? d) (eq? (car d) 'lambda))
         (and (pair? right) (equal? (cadr d) (cadr right)) (same-value? (caddr d) (caddr right)))]
        [(defines? right) #f]
        [(defines? d) #f]
        [else (same-value? d right)]))

(define (same-head? head right)
  (define (name h) (if (pair? h) (name (car h)) h))
  (and (eq? (name head) (name right))
       (or (not (pair? right)) (and (pair? head) (equal? (cdr head) (cdr right))))))

;; Code without a value is not the same.
(define (same-value? d right)
  (with-handlers ([exn:fail:contract? (lambda (e) #f)]) (same-values? d right)))

(define (same-values? d right)
  (for/and ([point (in-range 3)])
    (define-values (v w) (values (value d point) (value right point)))
    (or (< (magnitude (- v w)) (* 1e-9 (+ 1 (magnitude w))))
        (and (> (magnitude w) 1e30) (> (magnitude v) 1e30)))))

;; ---------------------------------------------------------------------------
;; The table

(define sections (call-with-input-file table (lambda (in) (for/list ([s (in-port read in)]) s))))
(define (entries sort) (append* (map (lambda (s) (cdr (assq sort (cdr s)))) sections)))

(define (check-offer text form needed?)
  (for ([code (list (offer text) (offer-of-row text))] [where '(prompt row)])
    (with-check-info (['text text] ['offered code] ['right form] ['where where])
      (when (and needed? (eq? where 'prompt)) (check-not-false code))
      (when code
        (check-true (and form
                         (or (same? code form)
                             (and (eq? where 'row) (same-relation? code form)))))))))

;; A row has no definitions, but relations.
(define (same-relation? code form)
  (and (pair? form) (eq? (car form) 'define) (pair? code) (eq? (car code) '=)
       (same-value? (last code) (last form))))

(define (check-table)
  (for ([e (in-list (entries 'must))]) (check-offer (car e) (cadr e) #t))
  (for ([e (in-list (entries 'may))]) (check-offer (car e) (cadr e) #f))
  (for ([text (in-list (entries 'none))]) (check-offer text #f #f)))

(test-case "every formula of the table is offered rightly, or not at all"
  (check-true (> (length (append (entries 'must) (entries 'may) (entries 'none))) 200))
  (check-table))

(test-case "the judge notices a wrong order, a lost factor and another name"
  (check-false (same? '(/ 1 (* 2 m)) '(* 1/2 m)))
  (check-false (same? '(/ (cos t) 2) '(* 3/2 (cos t))))
  (check-false (same? '(define (V y) (* k y)) '(define (V x) (* k x))))
  (check-true (same? '(define ((V k) x) (* 1/2 'k (expt x 2))) '(define (V x) (/ (* k x x) 2)))))

;; ---------------------------------------------------------------------------
;; Random formulas, with parentheses where they must be and some more

(define (random-formula depth)
  (define (part) (random-formula (- depth 1)))
  (if (or (= depth 0) (= 0 (random 5)))
      (list-ref '(a b c x y 2 3 1.5) (random 8))
      (case (random 8)
        [(0) (list 'sin (part))]
        [(1) (list '- (part))]
        [(2) (list 'expt (part) (list-ref '(2 3 n (- x) (expt y 2)) (random 5)))]
        [else (list (list-ref '(+ - * / *) (random 5)) (part) (part))])))

;; Levels: 0 a sum, 1 a product, 2 a factor, 3 the base of a power
(define (written d level)
  (define (at own text) (if (or (< own level) (= 0 (random 12))) (string-append "(" text ")") text))
  (define (between a sign b)
    (define space (if (= 0 (random 2)) " " ""))
    (string-append a space sign space b))
  (cond [(not (pair? d)) (format "~a" d)]
        [(eq? (car d) 'sin) (format "sin(~a)" (written (cadr d) 0))]
        [(eq? (car d) 'expt)
         (at 2 (string-append (written (cadr d) 3) "**" (written (caddr d) 2)))]
        [(null? (cddr d)) (at 2 (string-append "-" (written (cadr d) 2)))]
        [else
         (define own (if (memq (car d) '(+ -)) 0 1))
         (at own (between (written (cadr d) own) (symbol->string (car d))
                          (written (caddr d) (+ own 1))))]))

(test-case "random formulas are read rightly, nearly all of them"
  (random-seed 35)
  (define read-ones
    (for/sum ([_ (in-range 1000)])
      (define d (random-formula 4))
      (define text (written d 0))
      (define code (prefix-form (forms-in text)))
      (with-check-info (['formula d] ['text text] ['offered code])
        (when (and code (same-value? d d)) (check-true (same-value? code d))))
      (if code 1 0)))
  (check-true (> read-ones 900) (format "~a of 1000" read-ones)))

(module+ main
  (define (outcome text form)
    (define code
      (with-handlers ([exn:fail? (lambda (e) (list 'raises (exn-message e)))]) (offer text)))
    (cond [(not code) 'none] [(and form (same? code form)) 'right] [else 'wrong]))
  (for ([sort '(must may none)])
    (define results
      (for/list ([e (in-list (entries sort))])
        (define-values (text form) (if (pair? e) (values (car e) (cadr e)) (values e #f)))
        (define o (outcome text form))
        (when (or (eq? o 'wrong) (and (eq? sort 'must) (eq? o 'none)))
          (printf "~a: ~s ~s\n" o text (offer text)))
        o))
    (printf "~a: ~a\n" sort (for/list ([k '(right none wrong)])
                             (cons k (count (lambda (r) (eq? r k)) results))))))
