#lang racket/base
;; Mutations: small changes of a file's text that its syntax suggests.
;;
;; Each is one that a person makes by mistake: a comparison and its neighbour, a sign, a number and
;; its neighbour, arguments exchanged, a clause forgotten, a keyword not passed on, `not`, `abs`
;; or `max` left out.  What is quoted, required or provided stays as it is.

(require racket/list
         syntax/modread)

(provide mutations-of mutated-text program-of (struct-out mutation))

;; kind : symbol;  from, to : places in the text;  new : what stands there instead
(struct mutation (kind line from to new) #:prefab)

(define (mutated-text text m)
  (string-append (substring text 0 (mutation-from m)) (mutation-new m)
                 (substring text (mutation-to m))))

;; file : for messages of the reader -> list of mutations, in the order of the text
(define (mutations-of text file)
  (sort (found-in text (program-of text file)) < #:key mutation-from))

;; -> syntax
(define (program-of text file)
  (define port (open-input-string text))
  (port-count-lines! port)
  (with-module-reading-parameterization (lambda () (read-syntax file port))))

(define unchanged
  '(require provide quote quasiquote quote-syntax syntax quasisyntax syntax-case syntax-rules
    define-syntax define-syntax-rule define-syntaxes begin-for-syntax define-for-syntax
    complain complain-showing complain-of-argument check-argument raise-syntax-error module module*
    require-on-demand provide-on-demand for-syntax struct value-struct))

(define binders '(define define-values lambda λ))

(define (found-in text form)
  (define (source s) (substring text (start s) (end s)))
  (define (make kind s new) (mutation kind (syntax-line s) (start s) (end s) new))
  (define (walk s)
    (define parts (syntax->list s))
    (cond [(and parts (pair? parts)
                (memq (syntax-e (car parts)) unchanged)
                (not (and (eq? (syntax-e (car parts)) 'module) (= (length parts) 4))))
           '()]
          [(and parts (pair? parts) (memq (syntax-e (car parts)) binders) (pair? (cdr parts)))
           (append (defaults-in (cadr parts)) (append-map walk (cddr parts)))]
          [(and parts (pair? parts)) (append (of-form s parts make source) (append-map walk parts))]
          [else (of-atom s make)]))
  ;; Names that are bound stay as they are: the text would be no program.
  (define (defaults-in header)
    (for*/list ([part (in-list (or (syntax->list header) '()))]
                [inner (in-value (syntax->list part))]
                #:when (and inner (pair? inner))
                [value (in-list (cdr inner))]
                [m (in-list (walk value))])
      m))
  (if (eq? (car (syntax->datum form)) 'module)
      (append-map walk (cdddr (syntax->list form)))
      '()))

(define (start s) (sub1 (syntax-position s)))
(define (end s) (+ (start s) (syntax-span s)))

;; ---------------------------------------------------------------------------

(define exchanged
  #hasheq((< . "<=") (<= . "<") (> . ">=") (>= . ">") (fl< . "fl<=") (fl> . "fl>=")
          (+ . "-") (- . "+") (g:+ . "g:-") (g:- . "g:+") (fl+ . "fl-") (fl- . "fl+")
          (e:+ . "e:-") (e:- . "e:+") (* . "+") (fl* . "fl+") (g:* . "g:+")
          (add1 . "sub1") (sub1 . "add1") (max . "min") (min . "max") (flmax . "flmin")
          (and . "or") (or . "and") (when . "unless") (unless . "when") (andmap . "ormap")
          (ormap . "andmap") (first . "last") (even? . "odd?") (odd? . "even?")
          (for/and . "for/or") (for/or . "for/and")))

(define dropped '(not abs flabs g:abs reverse magnitude remove-duplicates))

(define (of-form s parts make source)
  (define head (syntax-e (car parts)))
  (append
   (cond [(and (symbol? head) (pair? (cdr parts)) (hash-ref exchanged head #f))
          => (lambda (new) (list (make 'exchanged (car parts) new)))]
         [else '()])
   (if (and (memq head dropped) (= (length parts) 2))
       (list (make 'dropped s (source (cadr parts))))
       '())
   (if (and (eq? head 'cond) (> (length parts) 2))
       (for/list ([clause (in-list (drop-right (cdr parts) 1))]) (make 'clause clause ""))
       '())
   (if (and (eq? head 'if) (= (length parts) 4))
       (list (make 'branches s (format "(if ~a ~a ~a)" (source (cadr parts)) (source (cadddr parts))
                                       (source (caddr parts)))))
       '())
   (exchanged-arguments head (cdr parts) make source)
   (forgotten-keywords (cdr parts) make)))

;; Two names beside each other, in a call
(define (exchanged-arguments head arguments make source)
  (define binding
    '(define lambda let let* letrec λ for for/list for/vector for/fold case-lambda set!
      define-values let-values parameterize match case cond struct-copy + * g:+ g:*
      and or eq? eqv? equal? list = fl+ fl* max min))
  (if (or (not (symbol? head)) (memq head binding))
      '()
      (for/list ([a (in-list arguments)]
                 [b (in-list (if (pair? arguments) (cdr arguments) '()))]
                 #:when (and (symbol? (syntax-e a)) (symbol? (syntax-e b))
                             (not (eq? (syntax-e a) (syntax-e b)))))
        (make 'arguments a (source b)))))

(define (forgotten-keywords arguments make)
  (for/list ([k (in-list arguments)]
             [v (in-list (if (pair? arguments) (cdr arguments) '()))]
             #:when (and (keyword? (syntax-e k)) (symbol? (syntax-e v))
                         (eq? (string->symbol (keyword->string (syntax-e k))) (syntax-e v))))
    (mutation 'keyword (syntax-line k) (start k) (end v) "")))

(define (of-atom s make)
  (define x (syntax-e s))
  (cond [(and (exact-integer? x) (< -1 x 1000)) (list (make 'number s (number->string (add1 x))))]
        [(flonum? x)
         (define other (if (and (rational? x) (not (zero? x))) (* 2.0 x) 1.0))
         (list (make 'number s (number->string other)))]
        [(eq? x #t) (list (make 'boolean s "#f"))]
        [(eq? x #f) (list (make 'boolean s "#t"))]
        [else '()]))
