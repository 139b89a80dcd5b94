#lang racket/base
;; Definite integrals by adaptive Gauss–Kronrod quadrature.
;;
;; The 10-point Gauss rule on [−1, 1] is exact for polynomials of degree 19.
;; Kronrod's 11 additional nodes, the zeros of the Stieltjes polynomial
;; belonging to the Legendre polynomial P₁₀, make of it a 21-point rule that is
;; exact to degree 31 and uses the 10 values again.  The difference of the two
;; results, K − G, estimates the error of the poorer one.  For a smooth function
;; K is far better than that; following QUADPACK (Piessens et al., 1983) the
;; estimate is
;;
;;     e = A · min(1, (200 |K − G| / A)^(3/2)),    A = ∫ |f − mean of f|,
;;
;; and never less than `rounding` times ∫ |f|.  The panel with the greatest
;; estimate is halved until the sum of the estimates is at most the tolerance
;; times ∫ |f| over the whole interval: the error is measured against the size
;; of the integrand, so that an integral which is zero by symmetry is no
;; exception.  As with any rule that samples, a peak much narrower than the
;; distance of the first 21 nodes can be missed.
;;
;; Sums are taken over differences from the value at the centre.  The weights
;; of both rules add up to 2, hence constants are integrated without any error
;; and slowly varying functions with little.

(require "failure.rkt" "sample.rkt")

(provide
 quadrature            ; (quadrature f low high) -> flonum
 quadrature/error)     ; the same -> (values flonum error-bound)

;; ---------------------------------------------------------------------------
;; The rule.  Nodes x > 0; the other ones are −x and 0.  Gauss weights are 0 at
;; the nodes Kronrod added.

(define nodes
  '#(0.1488743389816312108848260011297200
     0.2943928627014601981311266031038656
     0.4333953941292471907992659431657842
     0.5627571346686046833390000992726941
     0.6794095682990244062343273651148736
     0.7808177265864168970637175783450424
     0.8650633666889845107320966884234930
     0.9301574913557082260012071800595083
     0.9739065285171717200779640120844521
     0.9956571630258080807355272806890028))

(define kronrod-weights
  '#(0.1477391049013384913748415159720680
     0.1427759385770600807970942731387171
     0.1347092173114733259280540017717068
     0.1234919762620658510779581098310742
     0.1093871588022976418992105903258050
     0.0931254545836976055350654650833663
     0.0750396748109199527670431409161900
     0.0547558965743519960313813002445802
     0.0325581623079647274788189724593898
     0.0116946388673718742780643960621920))

(define kronrod-weight-at-centre 0.1494455540029169056649364683898212)

(define gauss-weights
  '#(0.2955242247147528701738929946513383
     0.0
     0.2692667193099963550912284215694694
     0.0
     0.2190863625159820439955349342281632
     0.0
     0.1494513491505805931457763396576973
     0.0
     0.0666713443086881375935688098933318
     0.0))

;; Rounding error of one panel, relative to ∫ |f|: 50 times 2⁻⁵².
(define rounding 1.11e-14)

;; ---------------------------------------------------------------------------
;; One panel

;; value ≈ ∫ f, error ≥ its error (estimated), size ≈ ∫ |f|, all from low to high.
(struct panel (low high value error size) #:authentic)

(define (integrate-panel f low high)
  (define centre (* 0.5 (+ low high)))
  (define half (* 0.5 (- high low)))
  (define middle (f centre))
  (define (differences sign)
    (for/vector #:length 10 ([x (in-vector nodes)])
      (- (f (+ centre (* sign half x))) middle)))
  (define right (differences +1.0))
  (define left (differences -1.0))
  (define kronrod (weighted-sum kronrod-weights left right values))
  (define gauss (weighted-sum gauss-weights left right values))
  (define (magnitude-about offset)         ; ∫ |f − middle − offset|
    (define (distance d) (abs (- d offset)))
    (* (abs half)
       (+ (* kronrod-weight-at-centre (distance 0.0))
          (weighted-sum kronrod-weights left right distance))))
  (define size (magnitude-about (- middle)))
  (panel low high
         (* half (+ (* 2.0 middle) kronrod))
         (error-estimate (abs (* half (- kronrod gauss)))
                         (magnitude-about (* 0.5 kronrod))
                         size)
         size))

(define (weighted-sum weights left right g)
  (for/fold ([sum 0.0]) ([w (in-vector weights)]
                         [l (in-vector left)]
                         [r (in-vector right)])
    (+ sum (* w (+ (g l) (g r))))))

(define (error-estimate difference spread size)
  (max (* rounding size)
       (if (or (= difference 0.0) (= spread 0.0))
           difference
           (* spread (min 1.0 (expt (/ (* 200.0 difference) spread) 1.5))))))

;; ---------------------------------------------------------------------------
;; The whole interval

;; A tolerance below twice the rounding error is taken as that.  `limit` bounds
;; the number of panels.  (edge) is called when a narrow panel at an end of the
;; interval is to be halved; (place x) is what the user knows x as.
(define (quadrature f low high
                    #:tolerance [tolerance 1e-10]
                    #:limit [limit 1000]
                    #:name [who 'quadrature])
  (define-values (value bound)
    (quadrature/error f low high
                      #:tolerance tolerance #:limit limit #:name who))
  value)

(define (quadrature/error f low high
                          #:tolerance [tolerance 1e-10]
                          #:limit [limit 1000]
                          #:place [place values]
                          #:edge [edge void]
                          #:name [who 'quadrature])
  (check-finite who low "limit of integration")
  (check-finite who high "limit of integration")
  (check-tolerance who tolerance)
  (define (g x) (sample who f x))
  (define whole
    (integrate-panel g (real->double-flonum low) (real->double-flonum high)))
  (define (raise-stuck value bound x)
    (raise-not-convergent who "the integral does not converge" value bound
                          "trouble near" (place x)))
  (refine (list whole) 1 whole (max tolerance (* 2.0 rounding)) limit raise-stuck edge g))

;; panels : sorted, greatest error first; count : how many.
(define (refine panels count whole tolerance limit raise-stuck edge f)
  (define value (sum-of panel-value panels))
  (define bound (sum-of panel-error panels))
  (cond [(<= bound (* tolerance (sum-of panel-size panels)))
         (values value bound)]
        [(or (>= count limit) (indivisible? (car panels)))
         (raise-stuck value bound (panel-centre (car panels)))]
        [else
         (define worst (car panels))
         (when (at-edge? worst whole) (edge))
         (define centre (panel-centre worst))
         (refine (insert (integrate-panel f (panel-low worst) centre)
                         (insert (integrate-panel f centre (panel-high worst))
                                 (cdr panels)))
                 (+ count 1) whole tolerance limit raise-stuck edge f)]))

(define (sum-of part panels)
  (for/fold ([sum 0.0]) ([p (in-list panels)]) (+ sum (part p))))

(define (panel-centre p) (* 0.5 (+ (panel-low p) (panel-high p))))

(define narrow (expt 0.5 12))

(define (at-edge? p whole)
  (and (or (= (panel-low p) (panel-low whole)) (= (panel-high p) (panel-high whole)))
       (< (abs (- (panel-high p) (panel-low p)))
          (* narrow (abs (- (panel-high whole) (panel-low whole)))))))

;; Too narrow for its nodes to be different numbers.
(define (indivisible? p)
  (define centre (panel-centre p))
  (<= (abs (- (panel-high p) (panel-low p)))
      (* 1e-14 (abs centre))))

(define (insert p panels)
  (if (or (null? panels) (>= (panel-error p) (panel-error (car panels))))
      (cons p panels)
      (cons (car panels) (insert p (cdr panels)))))
