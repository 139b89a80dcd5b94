#lang racket/base
;; Expressions and relations as terms of Coq about real numbers.
;;
;; Written as they stand: nothing is simplified, so that the theorem says what the question says.
;; A certificate that cannot be written raises `no-certificate`, with the reason in words.

(require racket/string
         "Coq-names.rkt"
         "../algebra/expression/exact-numbers.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/pi.rkt"
         "../algebra/expression/read.rkt"
         "../generic/describe.rkt" "../operation/operation-column.rkt")

(provide term relation-text (struct-out no-certificate) give-up
         rational-constant split-power)

;; reason : words after "no certificate yet: "
(struct no-certificate (reason) #:authentic)
(define (give-up text . data) (raise (no-certificate (apply format text data))))

;; Levels of precedence, as Coq has them: what binds less than its place asks for stands in ( ).
(define-values (sum product power atom) (values 1 2 3 4))

(struct written (text level) #:authentic)

;; ns : names -> string; of a level that may stand at one of the level `least`
(define (term e ns [least sum])
  (define (leaf x)
    (cond [(number? x) (number-text x)]
          [(pi-symbol? x) (number-times-pi (pi-multiple x))]
          [else (written (name-of ns x) atom)]))
  (define (walk e)
    (if (node? e)
        (or (hash-ref (names-texts ns) e #f)
            (let ([w (node-text e (map walk (node-args e)) ns)])
              (hash-set! (names-texts ns) e w)
              w))
        (leaf e)))
  (at-level (walk e) least))

(define (at-level w least)
  (if (>= (written-level w) least) (written-text w) (string-append "(" (written-text w) ")")))

(define (number-text x)
  (define q (rational-constant x))
  (define whole (format "~a" (numerator (abs q))))
  (define unsigned
    (if (integer? q) whole (format "~a / ~a" whole (denominator q))))
  (cond [(negative? q) (written (string-append "- " unsigned) sum)]
        [(integer? q) (written unsigned atom)]
        [else (written unsigned product)]))

;; A decimal is the number that is written: 9.8 is 98/10.
(define (rational-constant x)
  (cond [(and (exact-constant? x) (exact? x) (real? x)) x]
        [(and (real? x) (rational? x)) (inexact->exact (string->number (number->string x) 10 'read
                                                                       'decimal-as-exact))]
        [else (give-up "it speaks of a number that is not real")]))

(define (number-times-pi k)
  (if (eqv? k 1)
      (written "PI" atom)
      (written (format "~a * PI" (at-level (number-text k) product)) product)))

;; parts : what the operands are written as
(define (node-text n parts ns)
  (define head (node-head n))
  (cond [(eq? head op:+) (sum-of parts)]
        [(eq? head op:-) (infix " - " parts sum sum product)]
        [(eq? head op:*) (product-of parts)]
        [(eq? head op:/) (infix " / " parts product product power)]
        [(eq? head op:expt) (power-text (cadr (node-args n)) parts)]
        [(memq head (list op:up op:down)) parts]
        [(literal-head? head) (applied (function-name n ns) (flatten-parts parts))]
        [(hash-ref names-in-Coq (operation-key (operation-name head) (length parts)) #f)
         => (lambda (name) (applied name parts))]
        [else (give-up "Coq's library has no ~a" (operation-name head))]))

(define (function-name n ns)
  (define h (node-head n))
  (name-of ns (unknown-function (literal-head-name h) (literal-head-index h)
                                (length (flat-arguments n)))))

(define (flatten-parts parts)
  (cond [(null? parts) '()]
        [(list? (car parts)) (append (flatten-parts (car parts)) (flatten-parts (cdr parts)))]
        [else (cons (car parts) (flatten-parts (cdr parts)))]))

(define (sum-of parts)
  (written (for/fold ([text (written-text (car parts))]) ([p (in-list (cdr parts))])
             (define t (written-text p))
             (string-append text (if (negative-text? t) " " " + ") t))
           sum))

;; - x, and not (- 1) * x
(define (product-of parts)
  (define first (written-text (car parts)))
  (define rest (if (null? (cdr parts)) #f (infix " * " (cdr parts) product power power)))
  (cond [(not (and rest (negative-text? first) (not (written-compound? (car parts)))))
         (infix " * " parts product product power)]
        [(equal? first "- 1") (written (string-append "- " (at-level rest product)) sum)]
        [else (written (string-append first " * " (written-text rest)) sum)]))

(define (negative-text? t) (regexp-match? #rx"^- " t))
;; Is it more than a number?
(define (written-compound? w) (not (regexp-match? #px"^- [0-9]+( / [0-9]+)?$" (written-text w))))

;; first, rest : the levels that operands need
(define (infix sign parts level first rest)
  (written (string-join (cons (at-level (car parts) first)
                              (for/list ([p (in-list (cdr parts))]) (at-level p rest)))
                        sign)
           level))

(define (applied name parts)
  (written (string-join (cons name (for/list ([p (in-list parts)]) (at-level p atom)))) power))

(define-column names-in-Coq
  [sin "sin"] [cos "cos"] [tan "tan"] [asin "asin"] [acos "acos"] [atan "atan"]
  [sinh "sinh"] [cosh "cosh"] [tanh "tanh"] [asinh "arcsinh"]
  [exp "exp"] [log "ln"] [sqrt "sqrt"] [abs "Rabs"]
  [(acosh atanh erf sgn) (none "Coq's library of real numbers has no such function")]
  [atan2 "atan2"])

;; ---------------------------------------------------------------------------
;; Powers

;; k : exponent -> what is raised ('base, 'root, or 'exponential) and its whole exponent, or #f
(define (split-power k)
  (define q (and (number? k) (exact-exponent k)))
  (cond [(not q) (values 'exponential #f)]
        [(integer? q) (values 'base q)]
        [(eqv? 2 (denominator q)) (values 'root (numerator q))]
        [else (values 'exponential #f)]))

(define (power-text k parts)
  (define-values (kind n) (split-power k))
  (define base (car parts))
  (case kind
    [(base) (whole-power base n)]
    [(root) (whole-power (applied "sqrt" (list base)) n)]
    [else (applied "Rpower" parts)]))

(define (whole-power base n)
  (define (positive-power n)
    (if (= n 1) base (written (format "~a ^ ~a" (at-level base atom) n) power)))
  (if (positive? n)
      (positive-power n)
      (written (format "1 / ~a" (at-level (positive-power (- n)) power)) product)))

;; ---------------------------------------------------------------------------
;; Relations

;; d : a datum such as (> m 0), its sides data or expressions -> string
(define (relation-text d ns)
  (define (side x) (if (expression? x) x (datum->expression x)))
  (define-values (left right) (values (side (cadr d)) (side (caddr d))))
  (define (between sign a b) (format "~a ~a ~a" (term a ns) sign (term b ns)))
  (case (car d)
    [(>) (if (and (headed? left op:abs) (eqv? right 0))
             (between "<>" (car (node-args left)) 0)
             (between "<" right left))]
    [(<) (between "<" left right)]
    [(>=) (between "<=" right left)]
    [(<=) (between "<=" left right)]
    [(<>) (between "<>" left right)]
    [(=) (between "=" left right)]
    [(is-derivative)
     (define xs (flat-arguments left))
     (string-join
      (list* (if (null? (cdr xs)) "is_derive" (format "differentiable_~a" (length xs)))
             (function-name left ns)
             (for/list ([e (in-list (append xs (cddr d)))]) (term e ns atom))))]
    [else (give-up "it rests on ~a" (value->text d))]))
