#lang racket/base
;; Signs of quantities of a system with decimals, where these are known but for rounding.
;;
;; Stiffnesses 0.1 (1, −0.7; −0.7, 0.49) leave a direction without a force, but the determinant of
;; the decimals is 7·10⁻¹⁹, and its sign says nothing.  So decimals get names, as parameters have
;; them: the determinant is then 0, as it is whatever 0.1 and 0.7 stand for.  Where the names do not
;; tell, balls do, or it is open: each decimal is uncertain by some units in its last place.

(require "../algebra/ball/ball-tape.rkt" "../algebra/ball/ball-value.rkt"
         "../algebra/assumption/signs.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/flat-graph.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../algebra/simplify/declare-relations.rkt" "../algebra/simplify/simplify-expression.rkt"
         "../algebra/solve/factors.rkt" (only-in "../algebra/solve/root.rkt" sign-and-rest)
         "../calculus/expression-function.rkt"
         "../error/refusal.rkt"
         "../generic/scalar.rkt" "../generic/irrational.rkt" "../generic/up-down.rkt"
         "../value/shape.rkt")

(provide with-decimals-named sign-or-rest)

(define most-decimals 12)               ; that algebra with their names is worth

;; -> L, q and an alist: names for decimals, all positive, in both; as they were and '() where there
;;    are none, or too many, or L has no value at symbols
(define (with-decimals-named L q)
  (define-values (t at v)
    (values (string->uninterned-symbol "t") (symbols-like q "q") (symbols-like q "v")))
  (define e (if-raised raised? #f (L (up t at v))))
  (define names (make-hasheqv))
  (define (name x)
    (hash-ref! names (abs x)
               (lambda () (string->uninterned-symbol (format "c~a" (hash-count names))))))
  (define (named e)
    (decimals-replaced (irrational-as-expression e)
                       (lambda (x) (e:* (if (< x 0.0) -1 1) (name x)))))
  (define e* (and (scalar? e) (expression? e) (named e)))
  (define q* (and e* (s:map/r named q)))
  (if (and e* (<= 1 (hash-count names) most-decimals))
      (values (lambda (s)
                (evaluate-generically e* (map cons (cons t (append (scalars at) (scalars v)))
                                              (cons (ref s 0) (append (scalars (ref s 1))
                                                                      (scalars (ref s 2)))))))
              q*
              (for/list ([(x name) (in-hash names)]) (cons name x)))
      (values L q '())))

(define (ref s i) (vector-ref (tuple-elements s) i))

;; Exponents stay: xᶜ has other rules than x².
(define (decimals-replaced e replacement)
  (define (leaf x) (if (and (flonum? x) (rational? x) (not (= x 0.0))) (replacement x) x))
  (define (node n args)
    (define kept
      (if (eq? (node-head n) op:expt)
          (list (car args) (cadr (node-args n)))
          args))
    (rebuild (node-head n) kept))
  (node-fold e leaf node))

;; 1, 0 or −1, or an expression of the same sign.  decimals : an alist, as above; a sign that they
;; leave open is 0.
(define (sign-or-rest value A decimals)
  (define e (irrational-as-expression value))
  (define names (map car decimals))
  (define B (with-relations A (for/list ([c (in-list names)]) `(> ,c 0))))
  (define (numeric? e) (andmap (lambda (s) (memq s names)) (symbols-in e)))
  (define-values (sign rest)
    (cond [(and (numeric? e) (sign-by-balls e decimals)) => (lambda (s) (values s 1))]
          [else (sign-and-rest e B)]))
  (for/fold ([sign sign] [rest 1]
             #:result (if (eqv? rest 1)
                          sign
                          (sign-with-values (e:* sign rest) A decimals)))
            ([f (in-list (if (expression-node? rest) (expression-factors rest B) '()))])
    (if (numeric? (car f))
        (values (* sign (or (sign-by-balls (car f) decimals) 0)) rest)
        (values sign (e:* rest (car f))))))

(define (expression-node? e) (or (node? e) (symbol? e)))

;; Beside symbols the decimals have their values.
(define (sign-with-values e A decimals)
  (define-values (sign rest)
    (sign-and-rest (simplify-expression (substitute-expression e decimals) A) A))
  (if (eqv? rest 1) sign (e:* sign rest)))

;; 1 or −1, or #f
(define (sign-by-balls e decimals)
  (define (lookup leaf arguments) (number->value (cdr (assq leaf decimals)) precision))
  (define v (tape-value (expression->tape e) lookup precision))
  (define signs (if (symbol? v) (bitwise-ior positive negative) (value-signs v)))
  (cond [(signs-within? signs positive) 1] [(signs-within? signs negative) -1] [else #f]))

(define precision 256)
