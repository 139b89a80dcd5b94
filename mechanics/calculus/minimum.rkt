#lang racket/base
;; Minima of functions made by the generic arithmetic (SICM pp. 19 and 22).

(require racket/flonum
         "gradient.rkt" "number.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/structure.rkt"
         "../value/shape.rkt"
         (prefix-in numeric: "../numeric/minimize.rkt")
         "../numeric/nelder-mead.rkt" "../numeric/quasi-newton.rkt")

(provide minimize multidimensional-minimize)

;; (argument value steps) of a minimum of f between low and high.
(define (minimize f low high #:tolerance [tolerance 1e-8])
  (check-function-of-one-variable 'minimize f)
  (numeric:minimize (lambda (x) (number 'minimize (f x)))
                    (number 'minimize low) (number 'minimize high)
                    #:tolerance tolerance))

;; ---------------------------------------------------------------------------
;; In several variables

(define who 'multidimensional-minimize)

;; The argument, of the shape of `start`, at which f has a minimum: from the
;; gradient of f, or from its values alone if it cannot be differentiated.
(define (multidimensional-minimize f start
                                   #:tolerance [tolerance 1e-8]
                                   #:method [method #f]
                                   #:observe [observe void])
  (check-function-of-one-variable who f)
  (check-method method)
  (define s (list->tuple start))
  (define x (structure->flvector s (lambda (x) (number who x))))
  (define (argument x) (tuple-like start (flvector->structure s x)))
  (define (value x) (real->double-flonum (number who (f (argument x)))))
  (define-values (found y count)
    (case (or method (if (differentiable? f start s) 'quasi-newton 'nelder-mead))
      [(quasi-newton)
       (quasi-newton (value-and-gradient f start s) x #:tolerance tolerance #:name who
                     #:observe (lambda (x y) (observe (argument x) y)))]
      [else
       (nelder-mead value x #:tolerance tolerance #:name who
                    #:observe (lambda (x y) (observe (argument x) y)))]))
  (argument found))

(define (check-method m)
  (unless (memq m '(quasi-newton nelder-mead #f))
    (raise-argument-error who "'quasi-newton or 'nelder-mead" m)))

;; flvector -> value and gradient
(define ((value-and-gradient f start s) x)
  (define-values (y slope)
    (value-and-derivatives-at who (lambda (t) (f (tuple-like start t))) (flvector->structure s x)))
  (values (real->double-flonum (number who y))
          (for/flvector #:length (flvector-length x) ([i (in-range (flvector-length x))])
            (real->double-flonum (number who (slope i))))))

(define (differentiable? f start s)
  (define x (structure->flvector s (lambda (x) (number who x))))
  (with-handlers ([exn:fail? (lambda (e) #f)])
    ((value-and-gradient f start s) x)
    #t))

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
