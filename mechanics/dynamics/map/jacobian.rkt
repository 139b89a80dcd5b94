#lang racket/base
;; The derivatives of a map of the plane by its coordinates, as the matrix
;;
;;     a  b     dx' = a dx + b dy
;;     c  d     dy' = c dx + d dy
;;
;; They come from one run of the map on dual numbers for each coordinate; those of a map that
;; refuses these, from differences.  Whole turns between two images near each other are no
;; difference.

(require racket/flonum
         "map-of-the-plane.rkt"
         "../../calculus/derivative.rkt" "../../calculus/perturbed-value.rkt"
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/whole-turns.rkt" "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/optimization/differences.rkt"
         "../../value/shape.rkt")

(provide map-jacobian check-keeps-areas eigenvalues eigenvector jacobian-runner)

;; a, b, c and d of a matrix given as a vector of rows
(define (entries J)
  (values (entry J 0 0) (entry J 0 1) (entry J 1 0) (entry J 1 1)))

(define (determinant J)
  (define-values (a b c d) (entries J))
  (- (* a d) (* b c)))

;; step : the greatest step of finite differences
(define (map-jacobian who map x y [step 1e-3])
  (define image (point-image-at who map))
  (define at (up x y))
  (image at)                            ; a mistake of the map's own is seen here
  (with-handlers ([refusal? (lambda (e) (by-differences who image x y step))])
    (define slopes (scalars (derivative-at image at)))
    (define-values (a c b d)
      (apply values (for/list ([x (in-list slopes)]) (number-or-refuse x))))
    (vector (vector a b) (vector c d))))

;; points : lists of two coordinates; what : the things that need it, in the plural
(define (check-keeps-areas who map points what)
  (for ([p (in-list points)])
    (define factor (determinant (apply map-jacobian who map p)))
    (unless (< (abs (- factor 1)) 1e-6)
      (complain who
                (string-append "the map does not keep areas, which ~a need"
                               "\n  determinant of its derivatives: ~a\n  off by: ~a\n  at: ~a")
                what factor (abs (- factor 1)) (value->text (apply up p))))))

(define (number-or-refuse x)
  (define n (comparand (innermost x)))
  (if (rational? n) n (complain-of-argument 'map-jacobian "a number" x)))

(define (by-differences who image x y step)
  (define-values (by-x by-y)
    (values (differences who image step (lambda (s) (up (+ x s) y)))
            (differences who image step (lambda (s) (up x (+ y s))))))
  (for/vector ([x (in-flvector by-x)] [y (in-flvector by-y)]) (vector x y)))

(define (differences who image step along)
  (define middle (numbers (image (along 0.0))))
  (define (value s)
    (for/flvector #:length 2 ([z (in-flvector (numbers (image (along s))))]
                              [z0 (in-flvector middle)])
      (whole-turns-less (fl- z z0))))
  (define-values (slopes error count)
    (difference-derivative value 0.0 #:step (real->double-flonum step) #:tolerance 1e-4
                           #:name who))
  slopes)

(define (numbers p) (structure->flvector p (lambda (x) (comparand (innermost x)))))

;; ---------------------------------------------------------------------------
;; Eigenvalues and their directions

;; Solves λ² - trace λ + determinant = 0; returns the root greater in size first, of two complex
;; ones that with the positive imaginary part.
(define (eigenvalues J)
  (define half (* 1/2 (+ (entry J 0 0) (entry J 1 1))))
  (define product (determinant J))
  (define discriminant (- (* half half) product))
  (define root (sqrt discriminant))
  (cond [(< discriminant 0) (values (+ half root) (- half root))]
        [else
         (define greater (if (< half 0) (- half root) (+ half root)))
         (values greater
                 (if (= greater 0) greater (/ product greater)))]))

;; -> a direction x, y that J multiplies by the eigenvalue.  Where every direction is one, the
;; second call, with first? #f, returns another.
(define (eigenvector J eigenvalue [first? #t])
  (define-values (a b c d) (entries J))
  (cond [(not (= b 0)) (values b (- eigenvalue a))]
        [(not (= c 0)) (values (- eigenvalue d) c)]
        [(= a d) (if first? (values 1 0) (values 0 1))]
        [(= eigenvalue a) (values 1 0)]
        [else (values 0 1)]))

;; ---------------------------------------------------------------------------
;; For many points

;; -> a procedure that stores the derivatives at p in J, both flvectors: those of both
;; coordinates by x, then by y.  Only one image is checked: compiled code checks none.
(define (jacobian-runner who map x y)
  (point-image-of who map x y)
  (define image (image-at who map))
  (compiled-function-runner
   (compile-function (lambda (p) (derivative-at image p)) (up x y) #:name who)))
