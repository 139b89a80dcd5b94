#lang racket/base
;; Controls as they are written: [name from to], [name choices-or-start], with #:step and #:start.

(require (for-template racket/base "on-demand.rkt"))

(provide control-form)

;; stx : of the whole form, clause : of a control
;; -> the control's name, and the expression that makes the control
(define (control-form stx clause)
  (define parts (syntax->list clause))
  (unless (and (pair? parts) (identifier? (car parts)))
    (raise-syntax-error #f "a control begins with its name, as in [k 1 10]" stx clause))
  (define name (car parts))
  (define-values (operands options) (split-options stx clause (cdr parts)))
  (define (option keyword) (hash-ref options keyword #'#f))
  (values
   name
   (case (length operands)
     [(2) #`(number-control '#,name #,@operands #,(option '#:step) #,(option '#:start))]
     [(1) (refuse-step stx options)
          #`(value-control '#,name #,@operands
                           #,(if (hash-has-key? options '#:start)
                                 #`(lambda () #,(option '#:start))
                                 #'#f))]
     [else
      (raise-syntax-error
       #f "a control takes two numbers, a list of choices, #t, #f or a text, as in [k 1 10]"
       stx clause)])))

;; -> the expressions, and a hash of the keywords with theirs
(define (split-options stx clause parts)
  (let split ([parts parts] [operands '()] [options (hasheq)])
    (define keyword (and (pair? parts) (syntax-e (car parts))))
    (cond [(null? parts) (values (reverse operands) options)]
          [(not (keyword? keyword)) (split (cdr parts) (cons (car parts) operands) options)]
          [(not (memq keyword '(#:step #:start)))
           (raise-syntax-error #f (format "there is no keyword ~a here, only #:step and #:start"
                                          keyword)
                               stx (car parts))]
          [(hash-has-key? options keyword)
           (raise-syntax-error #f (format "~a stands twice" keyword) stx clause)]
          [(null? (cdr parts))
           (raise-syntax-error #f (format "nothing stands behind ~a" keyword) stx clause)]
          [else (split (cddr parts) operands (hash-set options keyword (cadr parts)))])))

(define (refuse-step stx options)
  (define step (hash-ref options '#:step #f))
  (when step
    (raise-syntax-error #f "#:step is for a range of numbers, as in [k 1 10 #:step 1/2]" stx step)))
