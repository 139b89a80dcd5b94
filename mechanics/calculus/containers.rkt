#lang racket/base
;; The contents of Racket's own containers, changed throughout: boxes, hash tables,
;; promises, parameters and structures of transparent types, which may carry a
;; function, and with it an ε, into another function.
;;
;; Containers that may change keep their identity: a value read from them is
;; changed as it comes out, and a value stored is changed back.  An opaque
;; structure does not show its fields and stays as it is.

(require racket/promise)

(provide map-contents)

;; change : any -> any.  restore : undoes it.
(define (map-contents change restore x)
  (cond [(box? x) (map-box change restore x)]
        [(hash? x) (map-hash change restore x)]
        [(promise? x) (delay (change (force x)))]
        [(parameter? x) (make-derived-parameter x restore change)]
        [(struct? x) (map-fields change x)]
        [else x]))

(define (map-box change restore b)
  (if (immutable? b)
      (box-immutable (change (unbox b)))
      (impersonate-box b
                       (lambda (b value) (change value))
                       (lambda (b value) (restore value)))))

(define (map-hash change restore h)
  (if (immutable? h)
      (for/fold ([new h]) ([(key value) (in-hash h)])
        (hash-set new key (change value)))
      (impersonate-hash h
                        (lambda (h key) (values key (lambda (h key value) (change value))))
                        (lambda (h key value) (values key (restore value)))
                        (lambda (h key) key)
                        (lambda (h key) key))))

;; A structure with each field changed, if its type lets one see and make it.
(define (map-fields change s)
  (define-values (type opaque-part?) (struct-info s))
  (cond [(or (not type) opaque-part?) s]
        [else
         (define fields (cdr (vector->list (struct->vector s))))
         (define changed (map change fields))
         (if (andmap eq? fields changed)
             s
             (apply (struct-type-make-constructor type) changed))]))
