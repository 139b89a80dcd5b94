#lang racket/base
;; One panel of Gauss–Kronrod quadrature: the integral of a function over an interval from 21
;; values, with an estimate of its error.
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
;; and never less than `rounding` times ∫ |f|.
;;
;; Sums are taken over differences from the value at the centre.  The weights
;; of both rules add up to 2, hence constants are integrated without any error
;; and slowly varying functions with little.
;;
;; Panels keep their values: the polynomial through them predicts the function
;; between the nodes.  Nodes are rounded, by up to half a unit δ of their last place, and a
;; function that changes by Δ from each to the next comes out wrong by about δ √Σ Δ²: that is
;; the effect of rounding x on a narrow peak far from 0, or on sin x near 10⁶.

(require racket/flonum
         (only-in "../constants.rkt" epsilon))

(provide (struct-out panel) integrate-panel panel-centre panel-width panel-least panel-greatest
         panel-polynomial panels-from-the-left rounding-of-nodes rounding-of-panel
         rounding)

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
;; middle, right, left : f at the centre, and f − middle at the nodes of either side
(struct panel (low high value error size middle right left) #:authentic)

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
         size
         middle right left))

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

(define (panel-centre p) (fl* 0.5 (fl+ (panel-low p) (panel-high p))))
(define (panel-width p) (flabs (fl- (panel-high p) (panel-low p))))

(define (panel-least p) (flmin (panel-low p) (panel-high p)))
(define (panel-greatest p) (flmax (panel-low p) (panel-high p)))

(define (panels-from-the-left panels) (sort panels fl< #:key panel-least))

;; The error of a sum of panels that the rounding of their nodes may make; as these are rounded
;; up and down, its square is a sum of squares.
(define (rounding-of-nodes panels)
  (flsqrt (for/fold ([sum 0.0]) ([p (in-list panels)])
            (define here (rounding-of-panel p))
            (fl+ sum (fl* here here)))))

(define (rounding-of-panel p)
  (define unit (fl* epsilon (flmax (flabs (panel-low p)) (flabs (panel-high p)))))
  (fl* unit (flsqrt (fl+ (squared-steps (panel-left p)) (squared-steps (panel-right p))))))

;; Values from the centre outwards, as differences from that at the centre.
(define (squared-steps differences)
  (for/fold ([sum 0.0] [before 0.0] #:result sum) ([y (in-flvector differences)])
    (define step (fl- y before))
    (values (fl+ sum (fl* step step)) y)))

;; ---------------------------------------------------------------------------
;; The polynomial through the values, by the barycentric formula (J.-P. Berrut and L. N.
;; Trefethen, SIAM Review 46, 2004, 501):  Σ wₖ yₖ/(u − uₖ) / Σ wₖ/(u − uₖ), with weights
;; wₖ = 1/Π (uₖ − uⱼ), here those of a node over that of the centre.

(define barycentric-weights
  (flvector
   -0.98888937044276259829 0.95537093444930020405 -0.90037808683085153019
   0.82633422644112592397 -0.73404126637011411506 0.62313967922980141567
   -0.4979182876073266101 0.36639361364529626906 -0.22826495059235808907
   0.078253508077889129957))

;; At x within the panel
(define (panel-polynomial p x)
  (define u (fl/ (fl- x (panel-centre p)) (fl* 0.5 (fl- (panel-high p) (panel-low p)))))
  (define-values (top bottom)
    (for/fold ([top 0.0] [bottom (fl/ 1.0 u)])
              ([w (in-flvector barycentric-weights)] [node (in-flvector nodes)]
               [r (in-flvector (panel-right p))] [l (in-flvector (panel-left p))])
      (define a (fl/ w (fl- u node)))
      (define b (fl/ w (fl+ u node)))
      (values (fl+ top (fl+ (fl* a r) (fl* b l))) (fl+ bottom (fl+ a b)))))
  (define y (fl+ (panel-middle p) (fl/ top bottom)))
  (if (fl< (flabs y) +inf.0) y (value-at-node p u)))

(define (value-at-node p u)
  (fl+ (panel-middle p)
       (for/fold ([found 0.0]) ([node (in-flvector nodes)] [r (in-flvector (panel-right p))]
                                [l (in-flvector (panel-left p))])
         (cond [(fl= u node) r] [(fl= u (fl- 0.0 node)) l] [else found]))))
