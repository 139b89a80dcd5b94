#lang racket/base
;; Linear systems and determinants that are being differentiated.
;;
;; With A = A₀ + δA and b = b₀ + δb, where the δ are multiples of an infinitesimal ε,
;;
;;     A₀ x = b − δA x,   so  x ← A₀⁻¹ b₀ + A₀⁻¹ (δb − δA x)
;;
;; gains a power of ε with each step: begun with A₀ x = b₀, one step makes it exact for
;; first derivatives, and n for jets of order n.  So only systems of values are ever solved,
;; as well as these are: with pivots if they are numbers, at run time if they are traced.
;; Derivatives in derivatives are taken off one by one, the outermost first.
;;
;; A determinant is the product of the pivots of elimination, chosen by their values; where
;; one but the last is 0 the division fails, though there may be a derivative.

(require "row-products.rkt" "traced-linear-system.rkt"
         "../../algebra/expression/expression.rkt"
         "../../generic/arithmetic.rkt" "../../generic/kind.rkt" "../../generic/scalar.rkt"
         "../../generic/tracing.rkt"
         "../../numeric/linear-algebra/row-operations.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide perturbed-system? perturbed-solutions many-rows? pivots-determinant)

;; ---------------------------------------------------------------------------
;; Systems

;; Does it have entries that are being differentiated, and none but numbers beneath, or
;; expressions that are traced?
(define (perturbed-system? A right)
  (and (many-rows? A)
       (not (all-entries? plain? A right))
       (let ([good? (if (being-traced?) expression? plain-number?)])
         (all-entries? (lambda (x) (good? (beneath x))) A right))))

(define (many-rows? A) (> (vector-length A) longest-formula))

(define (plain? x) (not (carrier? x)))
(define (beneath x) (if (carrier? x) (beneath (value x)) x))
(define (value x) ((kind-comparand (kind-of x)) x))

;; solve : rows right-hand-sides -> rows or 'singular; of values
;; -> likewise
(define (perturbed-solutions solve A right)
  (define outermost (outermost-of A right))
  (define tag (carrier-tag outermost))
  (define (varies? x) (and (carrier? x) (eqv? (carrier-tag x) tag)))
  (define (without-ε x) (if (varies? x) (value x) x))
  (define (with-ε x) (if (varies? x) (g:- x (value x)) 0))
  (define A₀ (rows-map without-ε A))
  (define inverse (solve A₀ (unit-rows (vector-length A))))
  (cond
    [(eq? inverse 'singular) 'singular]
    [else
     (define start (solve A₀ (rows-map without-ε right)))
     (define δA (rows-map with-ε A))
     (define δb (rows-map with-ε right))
     (for/fold ([x start]) ([_ (in-range ((kind-order (kind-of outermost)) outermost))])
       (rows-combine g:+ start
                     (rows-product inverse (rows-combine g:- δb (rows-product δA x)))))]))

;; An entry with the ε of greatest number.
(define (outermost-of A right)
  (for*/fold ([outermost #f]) ([rows (list A right)] [row (in-vector rows)] [x (in-vector row)]
                               #:when (carrier? x))
    (if (and outermost (> (carrier-tag outermost) (carrier-tag x))) outermost x)))

;; ---------------------------------------------------------------------------
;; Determinants

(define (size x) (magnitude (comparand x)))
(define (exact-zero? x) (eqv? x 0))

(define-row-operations (triangulate! clear-below! substitute-back!)
  0 exact-zero? g:- g:* g:/ size >)

;; Of numbers, some of which are being differentiated or of higher precision; #f: not so.
(define (pivots-determinant matrix)
  (define rows (rows-map values matrix))
  (define n-1 (- (vector-length matrix) 1))
  (define (too-small? pivot k) (and (< k n-1) (zero? (size pivot))))
  (define sign
    (and (all-entries? (lambda (x) (plain-number? (beneath x))) matrix)
         (triangulate! rows too-small?)))
  (and sign
       (for/fold ([product sign]) ([row (in-vector rows)] [k (in-naturals)])
         (g:* product (vector-ref row k)))))
