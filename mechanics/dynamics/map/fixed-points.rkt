#lang racket/base
;; Fixed points of a map and of its iterates, and the map near them.
;;
;; A displacement from the point is multiplied by the matrix M of the map's derivatives there.  Its
;; eigenvalues, the multipliers, decide: where areas are kept two of them have the product 1 and
;; are both on the unit circle, the point is *elliptic* and neighbours turn about it by the
;; angle of the multiplier; or both are real, and it is *hyperbolic*, with a reflection if they are
;; negative (SICM 4.1 to 4.3).

(require racket/flonum
         "jacobian.rkt" "map-on-tuples.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/printed-function.rkt"
         "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/optimization/trust-region.rkt")

(provide find-fixed-point fixed-point?
         ;; for those who look for many, or go on from one
         fixed-point-near fixed-point-angles fixed-point-matrix)

;; coordinates : a point or a state; multipliers : by falling size; determinant : of the matrix
;; error : how far off the point may be; matrix : a vector of rows; angles : list of booleans
(value-struct fixed-point
              (coordinates period multipliers kind determinant error matrix angles)
  #:text fixed-point->text)

(provide-parts fixed-point? "a fixed point, as find-fixed-point finds one"
  fixed-point-coordinates fixed-point-period fixed-point-multipliers fixed-point-kind
  fixed-point-rotation-angle fixed-point-determinant fixed-point-error)

(define-plain (find-fixed-point map guess #:period [period 1] #:tolerance [tolerance 1e-13])
  (check-argument 'find-fixed-point exact-positive-integer? period "a period, a positive integer")
  (define m (make-map-on-tuples 'find-fixed-point map guess period))
  (define-values (p z) (fixed-point-of 'find-fixed-point map m tolerance))
  (or (of-lesser-period map m z tolerance) p))

;; -> the point z with a lesser period, or #f if its period is the least
(define (of-lesser-period map m z tolerance)
  (define (back? d) (short? d z return-tolerance))
  (define (found k)
    (define-values (p at) (fixed-point-of 'find-fixed-point map (done-times m k z) tolerance))
    p)
  (for/or ([k (in-list (returns-after m z back?))])
    (if-raised refusal? #f (found k))))

;; A point comes back if it returns within this, relative to 1 + |x|.
(define return-tolerance 1e-9)

(define (fixed-point-near who map guess period tolerance [limit 100])
  (define-values (p z)
    (fixed-point-of who map (make-map-on-tuples who map guess period) tolerance limit))
  p)

;; A trust region for the displacement, the derivatives being exact where the map can be
;; differentiated, as those made of motions can.
;; -> the fixed point of m, an iterate of the map, and its coordinates as an flvector
(define (fixed-point-of who map m tolerance [limit 100])
  (define (less-unit rows) (rows-combine - rows (unit-rows (vector-length rows) 1.0 0.0)))
  (define (search)
    (trust-region (lambda (z) (displacement m z)) (lambda (z) (less-unit (slopes-of-image m z)))
                  (map-on-tuples-start m)
                  #:tolerance tolerance #:limit limit
                  #:argument (map-on-tuples-point m) #:name who))
  (define-values (z error)
    (if (of-section? map) (call-for-section who search) (search)))
  (define M (slopes-of-image m z))
  (define lost (rounding-error (less-unit M) z))
  (unless (fl< lost (fl* greatest-rounding-error (fl+ 1.0 (greatest z))))
    (raise-not-convergent who "no fixed point found: there it only moves by less than rounding"
                          ((map-on-tuples-point m) z) lost))
  (define multipliers (multipliers-of M))
  (define determinant (apply * multipliers))
  (values (fixed-point ((map-on-tuples-point m) z) (map-on-tuples-times m) multipliers
                       (kind-of multipliers (real-part determinant))
                       (real-part determinant) (max error lost) M (map-on-tuples-angles m))
          z))

;; An image is rounded: where it differs from z by nothing, z may be off by A⁻¹ ε z all the same,
;; with A the derivatives of the displacement.  Where A has no inverse there is a whole line of
;; fixed points, or nothing is known.  Of the components the greatest.
(define (rounding-error A z)
  (define inverse (floating-solutions A (unit-rows (vector-length A) 1.0 0.0)))
  (if (vector? inverse)
      (for/fold ([most 0.0]) ([row (in-vector inverse)])
        (flmax most (for/fold ([sum 0.0]) ([a (in-vector row)] [y (in-flvector z)])
                      (fl+ sum (flabs (fl* (fl* a y) (fl* 0.5 epsilon)))))))
      0.0))

;; A point with a greater error, relative to 1 + |x|, is none.
(define greatest-rounding-error 1e-2)

;; Where the energy is kept the fixed points of a section are a curve, one for each energy, along
;; which the derivatives of the displacement have no inverse.
(define (call-for-section who search)
  (define (advised e)
    (string-append
     (exn-message e)
     "\n  where the energy is kept a section has such points for each energy, none apart from others;"
     "\n  at one energy it is a map of the plane: (define (map q p return fail) ...), as HHmap is"))
  (with-handlers ([exn:fail:mechanics:not-convergent?
                   (lambda (e)
                     (raise (struct-copy exn:fail:mechanics:not-convergent e
                                         [message #:parent exn (advised e)])))]
                  [exn:fail:mechanics:singular:matrix?
                   (lambda (e)
                     (raise (struct-copy exn:fail:mechanics:singular:matrix e
                                         [message #:parent exn (advised e)])))])
    (search)))

(define (of-section? map) (eq? 'Poincare-map (made-by map)))

;; By falling size.
(define (multipliers-of M)
  (define n (vector-length M))
  (cond [(= n 2) (call-with-values (lambda () (eigenvalues M)) list)]
        [else
         (sort (or (real-matrix-eigenvalues (rows->flvector M) n) '()) > #:key magnitude)]))

;; A size within this of 1 is taken for 1.
(define unit-tolerance 1e-6)

(define (kind-of multipliers determinant)
  (define sizes (map magnitude multipliers))
  (define (on-circle? s) (<= (abs (- s 1)) unit-tolerance))
  (define (unit? l) (<= (magnitude (- (* l l) 1)) unit-tolerance))
  (cond [(ormap unit? multipliers) 'parabolic]
        [(andmap on-circle? sizes) 'elliptic]
        [(andmap (lambda (s) (< s 1)) sizes) 'attracting]
        [(andmap (lambda (s) (> s 1)) sizes) 'repelling]
        [(ormap on-circle? sizes) 'mixed]
        [(and (= (length sizes) 2) (< (car multipliers) 0) (> determinant 0))
         'reflection-hyperbolic]
        [else 'hyperbolic]))

;; The angle by which neighbours turn about an elliptic point in a period; #f of other points.
(define (fixed-point-rotation-angle p)
  (and (eq? (fixed-point-kind p) 'elliptic)
       (abs (angle (car (fixed-point-multipliers p))))))

(define (fixed-point->text p)
  (define turn (fixed-point-rotation-angle p))
  (define excess (- (fixed-point-determinant p) 1))
  (string-append
   (format "~a point of period ~a at ~a" (fixed-point-kind p) (fixed-point-period p)
           (value->text (fixed-point-coordinates p)))
   (format "\n  multipliers: ~a" (value->text (fixed-point-multipliers p)))
   (if turn (format "\n  rotation angle: ~a" turn) "")
   (if (> (abs excess) unit-tolerance)
       (format "\n  areas are not kept: the determinant is ~a" (fixed-point-determinant p))
       "")))
