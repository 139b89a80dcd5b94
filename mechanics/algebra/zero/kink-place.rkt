#lang racket/base
;; At which values of an unknown does an expression vanish, in a form that can be read?

(require "../expression/expression.rkt" "../expression/operation.rkt" "../expression/pi.rkt"
         "../expression/size.rkt" "../expression/symbols.rkt"
         "../solve/solve-equations.rkt")

(provide places-of wave?)

;; Longer equations are not solved.
(define longest 60)

;; -> equations, '() if it cannot be solved, #f if there is no zero
(define (places-of f unknowns A)
  (define xs (filter (lambda (x) (occurs? x f)) unknowns))
  (define x (and (= 1 (length xs)) (car xs)))
  (cond [(not (and x (< (expression-size f) longest) (not (within-unknown? x f)))) '()]
        [else
         (define solutions
           (with-handlers ([exn:fail:contract? (lambda (e) #f)]) ; an angle of no direction
             (solve-equations (list (turns f)) (list x) A)))
         (cond [(not solutions) '()]
               [(null? solutions) #f]
               [(and (trigonometric? x f) (not (wave? f))) '()]
               [else (for/list ([r (in-list solutions)] #:when (assq x (car r)))
                       `(= ,x ,(presented (cdr (assq x (car r))))))])]))

;; A place in flonums where there are flonums, which have become fractions on the way.
(define (presented value)
  (if (and (rational? value) (exact? value) (> (denominator value) (expt 2 32)))
      (exact->inexact value)
      value))

;; sin u vanishes where u = n π, cos u where u = (n + 1/2) π; sinh u, |u| and √u where u does.
(define (turns f)
  (cond [(and (node? f) (memq (node-head f) (list op:sinh op:abs op:sqrt))) (car (node-args f))]
        [(not (wave? f)) f]
        [else
         (define turn (if (eq? (node-head f) op:sin) 'n (e:+ 'n 1/2)))
         (e:- (car (node-args f)) (e:* exact-pi turn))]))

(define (wave? f)
  (and (node? f)
       (memq (node-head f) (list op:sin op:cos))
       (not (occurs? 'n f))))

;; Is x within the argument of a function that satisfies the predicate of heads?
(define (within-head? head? x e)
  (define place
    (node-fold e
               (lambda (leaf) (and (eq? leaf x) 'bare))
               (lambda (n parts)
                 (cond [(memq 'within parts) 'within]
                       [(not (memq 'bare parts)) #f]
                       [(head? (node-head n)) 'within]
                       [else 'bare]))))
  (eq? place 'within))

(define (within-unknown? x e) (within-head? literal-head? x e))
(define (trigonometric? x e) (within-head? (lambda (h) (memq h circular-functions)) x e))
