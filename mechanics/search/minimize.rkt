#lang racket/base
;; Minima of functions made by the generic arithmetic (SICM pp. 19 and 22).

(require racket/flonum
         "../calculus/gradient.rkt" "../calculus/number.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../numeric/flvector.rkt" "../numeric/progress.rkt" "../numeric/sample.rkt"
         (prefix-in numeric: "../numeric/search/brent-minimum.rkt")
         "../numeric/search/golden-section.rkt"
         (prefix-in numeric: "../numeric/search/nelder-mead.rkt")
         "../numeric/search/quasi-newton.rkt"
         "../value/shape.rkt")

(provide minimize brent-min golden-section-min
         multidimensional-minimize nelder-mead)

;; ---------------------------------------------------------------------------
;; In one variable: (argument value steps) of a minimum of f between low and high

(define-plain (minimize f low high #:tolerance [tolerance 1e-8] #:observe [observe void]
                        #:progress [progress? (report-progress)])
  (minimum-between 'minimize f low high tolerance observe progress?))

(define-plain (brent-min f low high [tolerance 1e-8] #:observe [observe void]
                         #:progress [progress? (report-progress)])
  (minimum-between 'brent-min f low high tolerance observe progress?))

(define (minimum-between who f low high tolerance observe progress?)
  (check-function-of-one-variable who f)
  (define a (number who low))
  (define b (number who high))
  (call-with-progress
   progress?
   (lambda (note!)
     (numeric:minimize (counted-values note! who (lambda (x) (number who (f x)))) a b
                       #:tolerance tolerance #:observe observe #:name who))))

;; done? : a tolerance, or a predicate of low, best and high argument, the values there
;; and the count of steps
(define-plain (golden-section-min f low high [done? 1e-8] #:observe [observe void]
                                  #:progress [progress? (report-progress)])
  (define who 'golden-section-min)
  (check-function-of-one-variable who f)
  (if (procedure? done?) (check-predicate who done?) (check-tolerance who done?))
  (define a (number who low))
  (define b (number who high))
  (call-with-progress
   progress?
   (lambda (note!)
     (golden-section (counted-values note! who (lambda (x) (number who (f x)))) a b
                     #:done? (if (procedure? done?) done? (width-at-most done?))
                     #:observe observe))))

(define (check-predicate who done?)
  (unless (accepts? done? 7)
    (raise-arguments-error
     who "a predicate that ends the search takes three arguments, the values there and a count"
     "given" done?)))

;; ---------------------------------------------------------------------------
;; In several variables: from the gradient, or, of a function that has none
;; everywhere or does not say in which direction it falls, from values alone

;; The argument, of the shape of `start`, at which f has a minimum; report : receives
;; it, the value there, the size of the gradient, #f where it is not known, and the
;; evaluations of f.
(define-plain (multidimensional-minimize f start
                                         #:tolerance [tolerance 1e-8]
                                         #:method [method #f]
                                         #:observe [observe void]
                                         #:report [report (lambda (x y size count) x)]
                                         #:progress [progress? (report-progress)])
  (define who 'multidimensional-minimize)
  (check-function-of-one-variable who f)
  (check-tolerance who tolerance)
  (check-method who method)
  (define-values (x argument) (point-and-argument who start))
  (define (search note!)
    (define watch (counting-search note! who (lambda (x y) (observe (argument x) y))))
    (search-by method who f x argument tolerance watch))
  (call-with-values (lambda () (call-with-progress progress? search)) report))

;; -> argument, value, size of the gradient or #f, evaluations
(define (search-by method who f x argument tolerance watch)
  (define (from-gradient [stuck void])
    (define-values (found y slope count)
      (quasi-newton (value-and-gradient who f argument) x #:tolerance tolerance #:name who
                    #:observe watch #:argument argument #:stuck stuck))
    (values (argument found) y (norm slope) count))
  (define (from-values x)
    (define-values (found y count)
      (numeric:nelder-mead (value-at who f argument) x #:tolerance tolerance #:name who
                           #:observe watch #:argument argument))
    (values (argument found) y #f count))
  (define (from-either)
    (let/ec return
      (define stuck-at
        (with-handlers ([exn:fail:mechanics:singular? (lambda (e) x)])
          (let/ec stuck
            (call-with-values (lambda () (from-gradient stuck)) return))))
      (from-values stuck-at)))
  (case method
    [(quasi-newton) (from-gradient)]
    [(nelder-mead) (from-values x)]
    [else (if (slopes? (value-and-gradient who f argument) x) (from-either) (from-values x))]))

;; (argument value evaluations); at the limit, of the best argument so far
(define-plain (nelder-mead f start [step #f] [tolerance 1e-8] [limit 20000]
                           #:observe [observe void]
                           #:progress [progress? (report-progress)])
  (define who 'nelder-mead)
  (check-function-of-one-variable who f)
  (when step (check-step who step))
  (check-tolerance who tolerance)
  (unless (exact-positive-integer? limit)
    (complain-of-argument who "a number of evaluations, a positive integer" limit))
  (define-values (x argument) (point-and-argument who start))
  (define (search note!)
    (define watch (counting-search note! who (lambda (x y) (observe (argument x) y))))
    (numeric:nelder-mead (value-at who f argument) x
                         #:step step #:tolerance tolerance #:limit limit #:name who
                         #:stop-at-limit? #t
                         #:observe watch #:argument argument))
  (define-values (found y count) (call-with-progress progress? search))
  (list (argument found) y count))

(define (check-method who m)
  (unless (memq m '(quasi-newton nelder-mead #f))
    (complain-of-argument who "'quasi-newton or 'nelder-mead" m)))

(define (check-step who step)
  (unless (and (real? step) (< 0 step +inf.0))
    (complain-of-argument who "a positive step" step)))

;; Can the function be differentiated at x, and does it fall from there?  Where the
;; gradient vanishes may be a maximum.
(define (slopes? value-and-gradient x)
  (define slope
    (with-handlers ([refusal? (lambda (e) #f)])
      (define-values (y slope) (value-and-gradient x))
      slope))
  (and slope (for/or ([g (in-flvector slope)]) (not (fl= g 0.0)))))

;; Where to start, as an flvector, and what an flvector is to the user.
(define (point-and-argument who start)
  (define s (list->tuple who start))
  (values (structure->flvector s (lambda (x) (number who x)))
          (lambda (x) (tuple-like start (flvector->structure s x)))))

;; flvector -> value and gradient
(define ((value-and-gradient who f argument) x)
  (define s (argument x))
  (define-values (y slopes)
    (value-and-derivatives-at who (lambda (t) (f (tuple-like s t))) (list->tuple who s)))
  (values (value-or-nan who y)
          (for/flvector #:length (flvector-length x) ([slope (in-vector slopes)])
            (value-or-nan who slope))))

(define ((value-at who f argument) x) (value-or-nan who (f (argument x))))

;; Outside of its domain a function may be complex.
(define (value-or-nan who y)
  (if (and (number? y) (not (real? y))) +nan.0 (real->double-flonum (number who y))))

;; A list, as the book gives coordinates at several times, is a tuple meanwhile.
(define (list->tuple who x)
  (cond [(list? x) (apply up (for/list ([y (in-list x)]) (list->tuple who y)))]
        [(or (tuple? x) (real? x)) x]
        [else
         (complain who "expected real numbers to start from, in a list or a tuple; given ~a"
                   (describe-with-value x))]))

(define (tuple-like given s)
  (if (list? given)
      (for/list ([x (in-list given)] [y (in-vector (structure-elements s))]) (tuple-like x y))
      s))
