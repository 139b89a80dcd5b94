#lang racket/base
;; Names for coordinates: the functions x, y …, the vector fields d/dx …, the 1-forms dx ….
;;
;;     (define-coordinates (up x y) R2-rect)
;;
;; defines x, y, d/dx, d/dy, dx, dy; `let-coordinates` and `using-coordinates` bind them in a body.
;; The pattern is a name, or a tuple of patterns.

(require (for-syntax racket/base)
         "basis.rkt" "manifold-chart.rkt" "manifold-function.rkt" "manifold-point.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/up-down.rkt")

(provide define-coordinates let-coordinates using-coordinates)

(define-syntax (define-coordinates stx)
  (syntax-case stx ()
    [(_ pattern system)
     (with-syntax ([(name ...) (all-names #'pattern stx)])
       (with-syntax ([(defined ...) (with-fields #'(name ...))])
         (syntax/loc stx (define-values (defined ...) (coordinate-fields system '(name ...))))))]
    [_ (raise-syntax-error #f "expected names and a chart: (define-coordinates (up x y) R2-rect)"
                           stx)]))

(define-syntax (let-coordinates stx)
  (syntax-case stx ()
    [(_ () body0 body ...) (syntax/loc stx (let () body0 body ...))]
    [(_ ([pattern system] more ...) body0 body ...)
     (with-syntax ([(name ...) (all-names #'pattern stx)])
       (with-syntax ([(defined ...) (with-fields #'(name ...))])
         (quasisyntax/loc stx
           (let-values ([(defined ...) (coordinate-fields system '(name ...))])
             (let-coordinates (more ...) body0 body ...)))))]
    [_ (raise-syntax-error
        #f "expected names with their charts: (let-coordinates ([(up x y) R2-rect]) body ...)"
        stx)]))

(define-syntax-rule (using-coordinates pattern system body0 body ...)
  (let-coordinates ([pattern system]) body0 body ...))

(begin-for-syntax
  (define (all-names pattern stx)
    (define names (names-in pattern stx))
    (define twice (check-duplicate-identifier names))
    (when twice (raise-syntax-error #f "two coordinates have the same name" stx twice))
    names)

  (define (names-in pattern stx)
    (let walk ([p pattern])
      (syntax-case p (up down)
        [name (identifier? #'name) (list #'name)]
        [(head part ...)
         (memq (syntax-e #'head) '(up down))
         (apply append (map walk (syntax->list #'(part ...))))]
        [#(part ...) (apply append (map walk (syntax->list #'(part ...))))]
        [_ (raise-syntax-error #f "expected a name, or (up name ...)" stx p)])))

  ;; x … -> x … d/dx … dx …
  (define (with-fields names)
    (define all (syntax->list names))
    (define (prefixed pattern)
      (for/list ([n (in-list all)])
        (datum->syntax n (string->symbol (format pattern (syntax-e n))) n)))
    (append all (prefixed "d/d~a") (prefixed "d~a"))))

;; -> the coordinates as functions, the basis of vector fields, the 1-forms
(define (coordinate-fields C names)
  (define who 'define-coordinates)
  (check-coordinate-system who C)
  (define n (coordinate-system-dimension C))
  (unless (= n (length names))
    (complain who "~a has ~a coordinate~a; names were given for ~a: ~a" (value->text C) n
              (if (= n 1) "" "s") (length names) names))
  (define named (with-coordinate-names C (list->vector names)))
  (apply values
         (append (for/list ([k (in-range n)]) (coordinate-function named k))
                 (vector->list (tuple-elements (coordinate-system->vector-basis named)))
                 (vector->list (tuple-elements (coordinate-system->1form-basis named))))))

(define (coordinate-function C k)
  (make-manifold-function C
                          (lambda (B)
                            (define x (coordinates-in C (generic-point B)))
                            (if (tuple? x) (vector-ref (tuple-elements x) k) x))
                          (lambda () (vector-ref (coordinate-system-names C) k))))
