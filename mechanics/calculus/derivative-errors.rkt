#lang racket/base
;; What D and partial say when they are misused.

(require "../generic/structure.rkt" "../generic/function.rkt" "../generic/describe.rkt"
         "../algebra/datum.rkt")

(provide raise-needs-function raise-arity-of-differentiated raise-no-such-component
         raise-not-differentiable-at check-path)

(define (complain format-string . args)
  (raise (exn:fail:contract (apply format format-string args)
                            (current-continuation-marks))))

(define (raise-needs-function who x)
  (complain "~a: needs a function; ~a is ~a~a"
            (datum->text who) (value->text x) (describe x)
            (if (or (number? x) (symbol? x))
                (format "\n  the constant function is (lambda (x) ~a)~a" (value->text x)
                        (if (symbol? x)
                            (format ", an unknown one (literal-function '~a)" x)
                            ""))
                "")))

;; f was asked for its derivative at arguments it does not take.
(define (raise-arity-of-differentiated f args who)
  (define name (value->text f))
  (define x (and (pair? args) (null? (cdr args)) (tuple? (car args)) (adopt (car args))))
  (define n (length args))
  (complain "~a: ~a takes ~a; it was given ~a~a"
            (datum->text (list who (value->datum f))) name (arity->text f)
            (cond [x (format "one ~a tuple of ~a" (structure-orientation x) (structure-length x))]
                  [(= n 1) (format "1 argument, ~a" (value->text (car args)))]
                  [else (format "~a arguments" n)])
            (suggestion f who args x)))

(define (suggestion f who args x)
  (cond [(and x (accepts? f (structure-length x)))
         (format ".\n  Did you mean ~a?"
                 (datum->text
                  (cons (list who (value->datum f))
                        (for/list ([e (in-vector (structure-elements x))]) (value->datum e)))))]
        [(and (not x) (accepts? f 1))
         (format ".\n  Did you mean ~a?"
                 (datum->text (list (list who (value->datum f))
                                    (cons 'up (map value->datum args)))))]
        [else ""]))

(define (raise-no-such-component path s)
  (complain "~a: there is no such component in ~a, ~a"
            (datum->text (cons 'partial path)) (value->text s)
            (if (tuple? s)
                (format "~a~a" (describe (adopt s)) (index-range (structure-length (adopt s))))
                (describe s))))

(define (index-range n)
  (if (zero? n) "" (format " (indices 0 to ~a)" (sub1 n))))

(define (raise-not-differentiable-at x)
  (cond [(pair? x) (complain "D: a list is not a tuple; use (up x y ...)\n  given: ~a" (value->text x))]
        [else (complain "D: cannot differentiate by ~a, ~a; expected a number or a tuple"
                        (value->text x) (describe x))]))

;; partial takes indices only: ((partial 0 F) x) is the slip to explain.
(define (check-path path)
  (for ([i (in-list path)])
    (unless (exact-nonnegative-integer? i)
      (cond [(procedure? i)
             (define indices (for/list ([j (in-list path)] #:unless (procedure? j)) j))
             (complain "partial: takes only indices; the function comes next: (~a ~a)"
                       (datum->text (cons 'partial indices)) (value->text i))]
            [else (complain "partial: an index is a natural number; given ~a" (value->text i))])))
  (when (null? path)
    (complain "partial: needs at least one index, as in (partial 0)")))
