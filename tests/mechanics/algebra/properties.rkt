#lang racket/base
;; Random expressions: simplification keeps their values, is idempotent, and
;; proves sound rewrites, while unsound ones are seen.

(require rackunit "random.rkt"
         mechanics/algebra/expression mechanics/algebra/operation
         mechanics/algebra/simplify mechanics/algebra/zero-test)

(define classes
  '((6 ()) (5 (rational)) (5 (trigonometric)) (5 (radical)) (5 (exponential))
    (4 (rational trigonometric radical exponential))
    (5 (rational trigonometric radical exponential))))

;; One message a seed that fails `property`, an expression's thunk -> #f or text.
(define (failures n depth kinds property)
  (define found '())
  (with-seeds n (lambda (seed thunk)
                  (define text (thunk))
                  (when text
                    (set! found (cons (format "seed ~a: ~a" seed text) found))))
    (property (random-expression depth kinds)))
  (reverse found))

;; Rewriting makes expressions several times as large.
(define smaller-classes
  (for/list ([c (in-list classes)]) (cons (- (car c) 1) (cdr c))))

(define (check-property name n property [classes classes])
  (for ([c (in-list classes)])
    (test-case (format "~a: depth ~a, ~a" name (car c) (cadr c))
      (check-equal? (failures n (car c) (cadr c) property) '()))))

(check-property "simplification keeps values" 80
  (lambda (e)
    (define s (simplify-expression e))
    (define lookup (random-lookup))
    (define v (value-at e lookup))
    (define w (value-at s lookup))
    (and v
         (not (and w (close? v w)))
         (format "~a at ~a is ~a, simplified ~a" e s v w))))

(check-property "simplification is idempotent" 80
  (lambda (e)
    (define s (simplify-expression e))
    (define again (simplify-expression s))
    (and (not (equal? (expression->datum s) (expression->datum again)))
         (format "~a, then ~a" s again))))

(check-property "a sound rewrite makes no difference" 15
  (lambda (e)
    (for/or ([rule (in-list sound-rewrites)])
      (define difference (simplify-expression (e:- e (rewrite e rule))))
      (and (not (eqv? difference 0))
           (format "~a of ~a leaves ~a" (car rule) e difference))))
  smaller-classes)

(test-case "an unsound rewrite is refuted"
  (for ([rule (in-list unsound-rewrites)])
    (define statuses
      (let ([found '()])
        (with-seeds 12 (lambda (seed thunk) (set! found (cons (thunk) found)))
          (let ([e (random-expression 4 '(trigonometric))])
            (zero-test-status (zero-test (e:- e (rewrite e rule))))))
        found))
    (check-not-false (memq 'refuted statuses) (format "~a" (car rule)))))

;; Every sum and product written backwards.
(define (mirrored e)
  (node-fold e values
             (lambda (n args)
               (make-node (node-head n) (if (commutative? n) (reverse args) args)))))

(define (commutative? n) (memq (head->datum (node-head n)) '(+ *)))

(test-case "the order in which operands were written makes no difference"
  (with-seeds 80 (lambda (seed thunk) (with-check-info (['seed seed]) (thunk)))
    (let ([e (random-expression 4 '(rational trigonometric radical))])
      (check-equal? (expression->datum (simplify-expression (mirrored e)))
                    (expression->datum (simplify-expression e))))))
