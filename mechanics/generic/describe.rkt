#lang racket/base
;; The datum and text of a value, its name in messages, and access to its scalars.

(require "kind.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/pi.rkt"
         "../algebra/expression/write.rkt")

(provide value->datum value->text write-value describe describe-with-value
         map-leaves leaves procedure-datum prop:printed-datum prop:word)

;; Of structs that are no kind of value: value -> the S-expression it prints as.
(define-values (prop:printed-datum prints-as-datum? printed-datum-of)
  (make-struct-type-property 'printed-datum))

;; Of such structs: their name in messages.
(define-values (prop:word has-word? word-of) (make-struct-type-property 'word))

;; The S-expression a value prints as: never a tag, an address or a struct.
(define (value->datum x)
  (cond [(number? x) x]
        [(has-kind? x) ((kind-datum (kind-of x)) x)]
        [(symbolic? x) (expression->datum x)]
        [(prints-as-datum? x) (value->datum ((printed-datum-of x) x))]
        [(vector? x) (cons 'up (for/list ([e (in-vector x)]) (value->datum e)))]
        [(procedure? x) (procedure-datum x)]
        [(pair? x) (cons (value->datum (car x)) (value->datum (cdr x)))]
        [else x]))

;; Racket names an anonymous procedure by its place in a file, which is noise.
(define (procedure-datum f)
  (define name (object-name f))
  (if (and (symbol? name)
           (not (regexp-match? #rx":[0-9]+:[0-9]+$" (symbol->string name))))
      name
      '<function>))

(define (value->text x) (datum->text (value->datum x)))
(define (write-value x port) (write-datum (value->datum x) port))

;; The kind of a value, as a message says it.
(define (describe x) (or (word-for x) "a value that is no part of the arithmetic"))

(define (word-for x)
  (cond [(number? x) "a number"]
        [(symbolic? x) "a number-like expression"]
        [(vector? x) (format "an up tuple of ~a" (vector-length x))]
        [(has-kind? x) ((kind-describe (kind-of x)) x)]
        [(procedure? x) "a function"]
        [(list? x) "a list"]
        [(string? x) "a string"]
        [(boolean? x) "a boolean"]
        [(void? x) "no value (void)"]
        [(has-word? x) (word-of x)]
        [else #f]))

;; "the number 3", "the procedure `-`", "(up x y), an up tuple of 2"; a value outside the
;; arithmetic describes itself: "(holonomic G)".
(define (describe-with-value x)
  (cond [(number? x) (format "the number ~a" x)]
        [(symbol? x) (format (if (pi-symbol? x) "the number ~a" "the symbol ~a") x)]
        [(and (procedure? x) (not (has-kind? x)) (not (prints-as-datum? x)))
         (if (eq? (procedure-datum x) '<function>)
             "a function without a name"
             (format "the procedure `~a`" (procedure-datum x)))]
        [(word-for x) => (lambda (word) (format "~a, ~a" (value->text x) word))]
        [else (value->text x)]))

;; f applied to each leaf of x: containers (structures, matrices) keep their
;; shape, everything else is a leaf.
(define (map-leaves f x)
  (define m (and (has-kind? x) (kind-map (kind-of x))))
  (cond [m (m f x)]
        [(vector? x)
         (for/vector #:length (vector-length x) ([e (in-vector x)])
           (map-leaves f e))]
        [else (f x)]))

;; The leaves, in order.
(define (leaves x)
  (define found '())
  (map-leaves (lambda (leaf) (set! found (cons leaf found)) leaf) x)
  (reverse found))
