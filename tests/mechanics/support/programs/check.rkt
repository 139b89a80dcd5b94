#lang racket/base
;; One random program through the library and through the oracle.

(require racket/list
         (prefix-in m: mechanics)
         "differences.rkt" "generate.rkt" "language.rkt"
         "../bigfloats.rkt" "../close.rkt")

(provide check-program random-check shrink (struct-out mode) modes)

;; The library's arithmetic
(define library
  (arithmetic
   (hasheq '+ m:+ '- m:- '* m:* '/ m:/ 'square m:square 'cube m:cube
           'sqrt m:sqrt 'exp m:exp 'log m:log 'sin m:sin 'cos m:cos 'tan m:tan
           'atan m:atan 'tanh m:tanh
           'up m:up 'down m:down 'ref m:ref 'compose m:compose 'D m:D 'partial m:partial
           'power-of-D (lambda (n) (m:expt m:D n)))
   values
   m:<))

;; ---------------------------------------------------------------------------
;; Modes of comparison

;; elementary? : do programs use functions that are not rational?
;; argument    : -> where the derivative is taken
;; ours        : program argument -> number.  oracle : the same by differences
;; tolerance   : relative to the larger of 1 and the value
(struct mode (name elementary? argument ours oracle tolerance))

(define (slope program) (m:D (run program library)))
(define (quotient A program x)
  (define operations (arithmetic-operations A))
  (((hash-ref operations 'D) (run program A)) x))

(define (random-rational) (/ (+ 1 (random 99)) 50))
(define (random-flonum) (+ 0.05 (* 2 (random))))

(define precision 1200)
(define (in-bigfloats program x)
  (parameterize ([(big 'bf-precision) precision])
    ((big 'bigfloat->flonum) (quotient (bigfloat-differences) program ((big 'bf) x)))))

(define exact
  (mode "exact" #f random-rational
        (lambda (program x) ((slope program) x))
        (lambda (program x) (quotient rational-differences program x))
        1e-25))

(define flonum
  (mode "flonum" #t random-flonum
        (lambda (program x) ((slope program) x))
        in-bigfloats
        1e-7))

;; The derivative at a symbol, with a number put for it afterwards.
(define symbolic
  (mode "symbolic" #t random-flonum
        (lambda (program x) (m:substitute ((slope program) 'x) 'x x))
        in-bigfloats
        1e-7))

(define exact-symbolic
  (mode "exact symbolic" #f random-rational
        (lambda (program x) (m:substitute ((slope program) 'x) 'x x))
        (lambda (program x) (quotient rational-differences program x))
        1e-25))

(define (modes)
  (if bigfloats? (list exact exact-symbolic flonum symbolic) (list exact exact-symbolic)))

;; ---------------------------------------------------------------------------
;; Judging

;; -> 'agrees, 'discarded, or the disagreement, a string.
(define (check-program m program x)
  (define expected
    (with-handlers ([exn:break? raise]
                    [(lambda (e) #t) (lambda (e) 'discarded)])
      ((mode-oracle m) program x)))
  (cond
    [(not (number? expected)) 'discarded]
    [else
     (define got
       (with-handlers ([exn:break? raise]
                       [exn:discard? (lambda (e) 'discarded)]
                       [exn:fail? (lambda (e) e)])
         ((mode-ours m) program x)))
     (cond [(eq? got 'discarded) 'discarded]
           [(and (exn? got) (regexp-match? #rx"has no order" (exn-message got))) 'discarded]
           [(exn? got) (format "raised: ~a" (exn-message got))]
           [(not (number? got)) (format "not a number: ~a" got)]
           [(close? got expected (mode-tolerance m)) 'agrees]
           [else (format "ours ~a, by differences ~a" (inexact got) (inexact expected))])]))

(define (inexact x) (if (exact? x) (exact->inexact x) x))

;; -> 'agrees, 'discarded, or (list mode program x disagreement)
(define (random-check m size)
  (define program (random-program size (mode-elementary? m)))
  (define x ((mode-argument m)))
  (define verdict (check-program m program x))
  (if (string? verdict) (list m program x verdict) verdict))

;; ---------------------------------------------------------------------------
;; Shrinking

;; The smallest program found that still disagrees, and how.
(define (shrink m program x verdict)
  (let try ([candidates (smaller program)])
    (cond [(null? candidates) (values program verdict)]
          [else
           (define v (check-program m (car candidates) x))
           (if (string? v)
               (shrink m (car candidates) x v)
               (try (cdr candidates)))])))

;; The program with a subexpression replaced by one of its own, or by a number.
(define (smaller program)
  (define (replacements e)
    (cond [(pair? e) (append '(1 x) (filter expression?
                                            (append* (map parts (cons (car e) (cdr e))))))]
          [(and (symbol? e) (not (eq? e 'x))) '(x)]
          [else '()]))
  (define (parts e) (if (pair? e) (cons e (filter pair? e)) (list e)))
  (define (variants e)
    (append (replacements e)
            (if (pair? e)
                (for*/list ([(part i) (in-indexed e)]
                            #:when (or (pair? part) (symbol? part))
                            [v (in-list (variants part))])
                  (list-set e i v))
                '())))
  (for/list ([body (in-list (variants (caddr program)))]
             #:when (< (size body) (size (caddr program))))
    (list 'lambda '(x) body)))

(define (expression? e)
  (or (number? e)
      (and (symbol? e) (not (memq e '(lambda let if for/fold delay ref expt partial))))
      (pair? e)))

(define (size e)
  (cond [(pair? e) (+ 1 (for/sum ([p (in-list e)]) (size p)))]
        [(eq? e 'x) 1.5]
        [(symbol? e) 2]
        [else 1]))
