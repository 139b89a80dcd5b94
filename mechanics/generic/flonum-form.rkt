#lang racket/base
;; From an expression in generic arithmetic to the same in flonum arithmetic.
;;
;; Entries of the table of operations are data; what they say of values of any kind
;; can be said of flonums in their own operations, which a compiler keeps in
;; registers.  Only those occur that give flonums for all flonums.

(require (for-template racket/base racket/flonum))

(provide flonum-form)  ; expression, identifiers that stand for flonums -> expression or #f

(define operations
  (hasheq '+ #'fl+ 'g:+ #'fl+ '- #'fl- 'g:- #'fl- '* #'fl* 'g:* #'fl* '/ #'fl/ 'g:/ #'fl/
          'exp #'flexp 'g:exp #'flexp 'sin #'flsin 'g:sin #'flsin 'cos #'flcos 'g:cos #'flcos))

(define (flonum-form expression variables)
  (let/ec return
    (define (variable? id) (memf (lambda (v) (bound-identifier=? v id)) variables))
    (let form ([e expression])
      (syntax-case e ()
        [(head argument ...)
         (with-syntax ([(a ...) (map form (syntax->list #'(argument ...)))])
           (case (syntax-e #'head)
             [(g:negate) #'(fl* -1.0 a ...)]
             [(g:square) (with-syntax ([(a) #'(a ...)]) #'(let ([x a]) (fl* x x)))]
             [(pole) (car (syntax->list #'(a ...)))]
             [(slope) (with-syntax ([(a b) #'(a ...)])
                        #'(let ([d b]) (if (fl= d 0.0) (head a d) (fl/ a d))))]
             [else (with-syntax ([operation (hash-ref operations (syntax-e #'head)
                                                      (lambda () (return #f)))])
                     #'(operation a ...))]))]
        [x (identifier? #'x) (if (variable? #'x) #'x (return #f))]
        [n (real? (syntax-e #'n)) (datum->syntax #'n (real->double-flonum (syntax-e #'n)))]))))
