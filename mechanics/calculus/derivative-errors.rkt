#lang racket/base
;; Messages for misuse of D and partial.

(require "literal-function.rkt"
         (only-in "../algebra/expression/expression.rkt" node?)
         "../algebra/expression/symbols.rkt" "../algebra/expression/write.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/elementary.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/multiplied-function.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt"
         (only-in "../value/structure.rkt" index-range))

(provide raise-needs-function raise-takes-only-function raise-arity-of-differentiated
         raise-no-such-component raise-not-differentiable-at check-path)

(define (raise-needs-function who x)
  (complain (datum->text who) "needs a function; ~a is ~a~a"
            (value->text x) (describe x)
            (cond [(number? x) (format "\n  the constant function is (lambda (x) ~a)" x)]
                  [(symbol? x)
                   (format (string-append "\n  the constant function is (lambda (t) '~a), "
                                          "an unknown one (literal-function '~a)")
                           x x)]
                  [(and (node? x) (pair? (symbols-in x)))
                   (format "\n  the function with this value is (lambda (~a) ~a)"
                           (car (symbols-in x)) (value->text x))]
                  [else (list-hint x)])))

;; (D f x), where ((D f) x) is meant.
(define (raise-takes-only-function who args)
  (complain (datum->text who) "takes one function; it was given ~a~a"
            (if (null? args) "no argument" (format "~a arguments" (length args)))
            (cond [(or (null? args) (ormap procedure? (cdr args))) ""]
                  [(or (procedure? (car args)) (symbol? (car args)))
                   (format ", and the arguments of its derivative come after that~a"
                           (did-you-mean (car args) who (cdr args)))]
                  [else ""])))

;; f was asked for its derivative at arguments it does not take.
(define (raise-arity-of-differentiated f args who)
  (define name (value->text f))
  (define x (and (pair? args) (null? (cdr args)) (tuple? (car args)) (adopt (car args))))
  (define n (length args))
  (define derivative (datum->text (list who (value->datum f))))
  (when (and (null? args) (accepts? f 0))
    (complain derivative "needs at least one argument, to differentiate by; it was given none"))
  (complain derivative "~a takes ~a; it was given ~a~a" name (arity->text f)
            (cond [x (format "one ~a tuple of ~a" (structure-orientation x) (structure-length x))]
                  [(= n 1) (format "1 argument, ~a" (value->text (car args)))]
                  [else (format "~a arguments" n)])
            (suggestion f who args x)))

(define (suggestion f who args x)
  (cond [(and x (accepts? f (structure-length x)))
         (did-you-mean f who (vector->list (structure-elements x)))]
        [(and (not x) (pair? args) (accepts? f 1) (may-take? f (apply up args)))
         (did-you-mean f who (list (apply up args)))]
        [else ""]))

;; May f take the tuple, as far as is known without a trial?
(define (may-take? f tuple)
  (cond [(literal-function? f) (literal-function-takes? f (list tuple))]
        [else (not (memq f scalar-functions))]))

(define scalar-functions (map generic-op-procedure elementary-operations))

(define (did-you-mean f who args)
  (format ".\n  Did you mean ~a?"
          (datum->text (cons (list who (value->datum f)) (map typed-datum args)))))

;; The datum that is typed to get x, with symbols quoted.
(define (typed-datum x)
  (let quote-symbols ([d (value->datum x)])
    (cond [(symbol? d) (quoted d)]
          [(and (pair? d) (list? d)) (cons (car d) (map quote-symbols (cdr d)))]
          [else d])))

(value-struct quoted (symbol)
  #:text (lambda (q) (format "'~s" (quoted-symbol q))))

(define (raise-no-such-component path s)
  (complain (datum->text (cons 'partial path)) "there is no such component in ~a, ~a~a"
            (value->text s)
            (if (tuple? s)
                (format "~a~a" (describe (adopt s)) (index-range (structure-length (adopt s))))
                (describe s))
            (if (and (not (tuple? s)) (null? (cdr path)))
                "\n  the derivative of a function of one number is (D f)"
                "")))

(define (raise-not-differentiable-at x who)
  (complain who "cannot differentiate by ~a; expected a number or a tuple~a~a"
            (describe-with-value x) (list-hint x) (multiplied-hint x)))

;; partial takes indices only: ((partial 0 F) x) is the slip to explain.
(define (check-path path)
  (for ([i (in-list path)])
    (unless (exact-nonnegative-integer? i)
      (cond [(procedure? i)
             (define indices (for/list ([j (in-list path)] #:unless (procedure? j)) j))
             (complain 'partial "takes only indices; the function comes next: (~a ~a)"
                       (datum->text (cons 'partial indices)) (value->text i))]
            [else (complain 'partial "an index is a natural number; given ~a" (value->text i))])))
  (when (null? path)
    (complain 'partial "needs at least one index, as in (partial 0)")))
