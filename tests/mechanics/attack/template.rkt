#lang racket/base
;; Questions as templates: forms in which names in capitals stand for parts that are chosen, and
;; (line e) and its kin for functions of which e is the value.  Other symbols in e are
;; parameters, and quoted.

(require racket/list
         "statement.rkt")

(provide filled question-of)

(define arguments
  (hasheq 'line '((up t x v)) 'plane '((up t (up x y) (up u v))) 'state '((up t x p))
          'path '(t) 'action '(t x) 'integrand '(x) 'value #f))

(define parts
  (hasheq 'local '(up 't 'x 'v) 'local-plane '(up 't (up 'x 'y) (up 'u 'v))
          'local-state '(up 't 'x 'p) 'free '(* 1/2 (square v))))

;; choices : ((symbol . form) ...)
(define (filled e choices)
  (let walk ([e e])
    (cond [(pair? e) (cons (walk (car e)) (walk (cdr e)))]
          [(assq e choices) => cdr]
          [else (hash-ref parts e e)])))

(define (question-of program matter choices)
  (inquiry (written (filled program choices)) (filled matter choices)))

(define (written e)
  (define-values (head rest) (if (pair? e) (values (car e) (cdr e)) (values #f #f)))
  (cond [(hash-ref arguments head #f)
         => (lambda (bound) `(lambda ,bound ,(quoted-symbols (car rest) (flatten bound))))]
        [(eq? head 'value) (quoted-symbols (car rest) '())]
        [(and head (not (eq? head 'quote))) (map written e)]
        [else e]))
