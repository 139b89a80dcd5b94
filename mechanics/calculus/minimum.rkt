#lang racket/base
;; Minima of functions made by the generic arithmetic (SICM pp. 19 and 22).

(require racket/flonum
         "gradient.rkt" "number.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/structure.rkt"
         "../value/shape.rkt"
         (prefix-in numeric: "../numeric/minimize.rkt")
         "../numeric/failure.rkt" "../numeric/nelder-mead.rkt" "../numeric/quasi-newton.rkt")

(provide minimize multidimensional-minimize)

;; (argument value steps) of a minimum of f between low and high.
(define (minimize f low high #:tolerance [tolerance 1e-8])
  (check-function-of-one-variable 'minimize f)
  (numeric:minimize (lambda (x) (number 'minimize (f x)))
                    (number 'minimize low) (number 'minimize high)
                    #:tolerance tolerance))

;; ---------------------------------------------------------------------------
;; In several variables: from the gradient, or, of a function that has none
;; everywhere or does not say in which direction it falls, from values alone

(define who 'multidimensional-minimize)

;; The argument, of the shape of `start`, at which f has a minimum.
(define (multidimensional-minimize f start
                                   #:tolerance [tolerance 1e-8]
                                   #:method [method #f]
                                   #:observe [observe void])
  (check-function-of-one-variable who f)
  (check-method method)
  (define s (list->tuple start))
  (define x (structure->flvector s (lambda (x) (number who x))))
  (define (argument x) (tuple-like start (flvector->structure s x)))
  (define (watch x y) (observe (argument x) y))
  (define gradient (value-and-gradient f start s))
  (define (from-gradient)
    (define-values (found y count)
      (quasi-newton gradient x #:tolerance tolerance #:name who #:observe watch))
    found)
  (define (from-values)
    (define-values (found y count)
      (nelder-mead (lambda (x) (value-or-nan (f (argument x)))) x
                   #:tolerance tolerance #:name who #:observe watch))
    found)
  (argument
   (case method
     [(quasi-newton) (from-gradient)]
     [(nelder-mead) (from-values)]
     [else (if (slopes? gradient x) (unless-kinked from-gradient from-values) (from-values))])))

(define (check-method m)
  (unless (memq m '(quasi-newton nelder-mead #f))
    (raise-argument-error who "'quasi-newton or 'nelder-mead" m)))

;; Can the function be differentiated at x, and does it fall from there?  Where the
;; gradient vanishes may be a maximum.
(define (slopes? value-and-gradient x)
  (define slope
    (with-handlers ([exn:fail? (lambda (e) #f)])
      (define-values (y slope) (value-and-gradient x))
      slope))
  (and slope (for/or ([g (in-flvector slope)]) (not (fl= g 0.0)))))

;; The search may come to a point where there is no derivative.
(define (unless-kinked search otherwise)
  (define found
    (with-handlers ([exn:fail:mechanics:singular? (lambda (e) #f)])
      (search)))
  (or found (otherwise)))

;; flvector -> value and gradient
(define ((value-and-gradient f start s) x)
  (define-values (y slope)
    (value-and-derivatives-at who (lambda (t) (f (tuple-like start t))) (flvector->structure s x)))
  (values (value-or-nan y)
          (for/flvector #:length (flvector-length x) ([i (in-range (flvector-length x))])
            (value-or-nan (slope i)))))

;; Outside of its domain a function may be complex.
(define (value-or-nan y)
  (if (and (number? y) (not (real? y))) +nan.0 (real->double-flonum (number who y))))

;; A list, as the book gives coordinates at several times, is a tuple meanwhile.
(define (list->tuple x)
  (cond [(list? x) (apply up (map list->tuple x))]
        [(or (tuple? x) (real? x)) x]
        [else
         (raise
          (exn:fail:contract
           (format "~a: expected real numbers to start from, in a list or a tuple; given ~a"
                   who (describe-with-value x))
           (current-continuation-marks)))]))

(define (tuple-like given s)
  (if (list? given)
      (for/list ([x (in-list given)] [y (in-vector (structure-elements s))]) (tuple-like x y))
      s))
