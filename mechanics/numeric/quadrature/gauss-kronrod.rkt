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
;; and never less than `rounding` times ∫ |f|.  Panels are halved, in each round
;; those with an estimate of more than half of the greatest, until the sum of the
;; estimates is at most the tolerance times ∫ |f| over the whole interval: the error
;; is measured against the size of the integrand, so that an integral which is zero
;; by symmetry is no exception.  At a singularity a round is one panel, where a
;; function oscillates it is most of them; so the sums, made anew in each, cost
;; little.  As with any rule that samples, a peak much narrower than the distance of
;; the first 21 nodes can be missed.
;;
;; Sums are taken over differences from the value at the centre.  The weights
;; of both rules add up to 2, hence constants are integrated without any error
;; and slowly varying functions with little.

(require racket/flonum
         "../sample.rkt"
         "../../error/failure.rkt")

(provide
 quadrature            ; (quadrature f low high) -> flonum
 quadrature/error)     ; the same -> (values flonum error-bound)

;; ---------------------------------------------------------------------------
;; The rule.  Nodes x > 0; the other ones are −x and 0.  Gauss weights are 0 at
;; the nodes Kronrod added.

(define nodes
  (flvector
   0.1488743389816312108848260011297200
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
  (flvector
   0.1477391049013384913748415159720680
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
  (flvector
   0.2955242247147528701738929946513383
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
  (define centre (fl* 0.5 (fl+ low high)))
  (define half (fl* 0.5 (fl- high low)))
  (define middle (f centre))
  (define right (differences f centre half middle))
  (define left (differences f centre (fl- 0.0 half) middle))
  (define-values (kronrod gauss) (weighted-sums left right))
  (define size (magnitude-about (fl- 0.0 middle) left right half))
  (panel low high
         (fl* half (fl+ (fl* 2.0 middle) kronrod))
         (error-estimate (flabs (fl* half (fl- kronrod gauss)))
                         (magnitude-about (fl* 0.5 kronrod) left right half)
                         size)
         size))

;; f − middle at the nodes on one side
(define (differences f centre half middle)
  (for/flvector #:length 10 ([x (in-flvector nodes)])
    (fl- (f (fl+ centre (fl* half x))) middle)))

(define (weighted-sums left right)
  (for/fold ([kronrod 0.0] [gauss 0.0])
            ([k (in-flvector kronrod-weights)] [g (in-flvector gauss-weights)]
             [l (in-flvector left)] [r (in-flvector right)])
    (define both (fl+ l r))
    (values (fl+ kronrod (fl* k both)) (fl+ gauss (fl* g both)))))

;; ∫ |f − middle − offset|
(define (magnitude-about offset left right half)
  (fl* (flabs half)
       (for/fold ([sum (fl* kronrod-weight-at-centre (flabs offset))])
                 ([k (in-flvector kronrod-weights)] [l (in-flvector left)] [r (in-flvector right)])
         (fl+ sum (fl* k (fl+ (flabs (fl- l offset)) (flabs (fl- r offset))))))))

(define (error-estimate difference spread size)
  (max (* rounding size)
       (if (or (= difference 0.0) (= spread 0.0))
           difference
           (* spread (min 1.0 (expt (/ (* 200.0 difference) spread) 1.5))))))

;; ---------------------------------------------------------------------------
;; The whole interval

;; A tolerance below twice the rounding error is taken as that.  `limit` bounds
;; the number of panels.  (edge) is called when a narrow panel at an end of the
;; interval is to be halved; (stuck value bound x) when no halving helps, at an x
;; where a panel cannot be halved any more, or #f if there are too many; (place x) is
;; what the user knows x as.
(define (quadrature f low high
                    #:tolerance [tolerance 1e-10]
                    #:limit [limit most-panels]
                    #:name [who 'quadrature])
  (define-values (value bound)
    (quadrature/error f low high
                      #:tolerance tolerance #:limit limit #:name who))
  value)

(define (quadrature/error f low high
                          #:tolerance [tolerance 1e-10]
                          #:limit [limit most-panels]
                          #:place [place values]
                          #:edge [edge void]
                          #:stuck [stuck void]
                          #:name [who 'quadrature])
  (check-finite who low "limit of integration")
  (check-finite who high "limit of integration")
  (check-tolerance who tolerance)
  (define (g x) (sample who f x))
  (define whole
    (integrate-panel g (real->double-flonum low) (real->double-flonum high)))
  (define (raise-stuck value bound worst)
    (define x (panel-centre worst))
    (stuck value bound (and (indivisible? worst whole) x))
    (raise-divergent-integral who value bound (place x)))
  (refine (list whole) 1 whole (max tolerance (* 2.0 rounding)) limit raise-stuck edge g))

(define most-panels 10000)

;; count : how many panels
(define (refine panels count whole tolerance limit raise-stuck edge f)
  (define-values (value bound size worst) (totals panels))
  (cond [(<= bound (* tolerance size)) (values value bound)]
        [(or (>= count limit) (indivisible? worst whole))
         (raise-stuck value bound worst)]
        [else
         (define threshold (fl* 0.5 (panel-error worst)))
         (define-values (next added)
           (for/fold ([next '()] [added 0]) ([p (in-list panels)])
             (cond [(or (eq? p worst)
                        (and (fl> (panel-error p) threshold) (not (indivisible? p whole))))
                    (when (at-edge? p whole) (edge))
                    (define centre (panel-centre p))
                    (values (list* (integrate-panel f (panel-low p) centre)
                                   (integrate-panel f centre (panel-high p))
                                   next)
                            (+ added 1))]
                   [else (values (cons p next) added)])))
         (refine next (+ count added) whole tolerance limit raise-stuck edge f)]))

;; -> the sums of values, of errors and of sizes, and the panel of greatest error
(define (totals panels)
  (for/fold ([value 0.0] [bound 0.0] [size 0.0] [worst (car panels)]) ([p (in-list panels)])
    (values (fl+ value (panel-value p))
            (fl+ bound (panel-error p))
            (fl+ size (panel-size p))
            (if (fl> (panel-error p) (panel-error worst)) p worst))))

(define (panel-centre p) (fl* 0.5 (fl+ (panel-low p) (panel-high p))))
(define (panel-width p) (flabs (fl- (panel-high p) (panel-low p))))

(define narrow (expt 0.5 12))

(define (at-edge? p whole)
  (and (or (fl= (panel-low p) (panel-low whole)) (fl= (panel-high p) (panel-high whole)))
       (fl< (panel-width p) (fl* narrow (panel-width whole)))))

;; Too narrow for its nodes to be different numbers, or after so many halvings that
;; the function must be infinite there.
(define narrowest (expt 0.5 200))

(define (indivisible? p whole)
  (or (fl<= (panel-width p) (fl* 1e-14 (flabs (panel-centre p))))
      (fl<= (panel-width p) (fl* narrowest (panel-width whole)))))
