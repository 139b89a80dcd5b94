#lang racket/base
;; Motions on a manifold: charts are changed before one becomes singular.
;;
;; A Lagrangian is written in some chart.  In another it is the same function of the motion, made
;; by the induced transformation of local tuples and simplified, so that what is singular in the
;; first chart alone is gone.  The motion is followed in one chart until that is much less fit than
;; where the stretch began, and goes on in the fittest one.  States, events and all else that is
;; asked of the trajectory are those of its home chart, with angles that do not jump.

(require racket/list
         (only-in racket/math sgn)
         "chart-choice.rkt" "manifold-chart.rkt" "manifold-function.rkt" "manifold-point.rkt"
         "../calculus/expression-function.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/coordinate-transformation.rkt" "../lagrangian/local-tuple.rkt"
         "../lagrangian/state-derivative.rkt"
         "../motion/event/event.rkt" "../motion/evolve-trajectory.rkt" "../motion/trajectory.rkt"
         "../numeric/constants.rkt"
         "../value/compose.rkt" "../value/shape.rkt" "../value/simplify.rkt")

(provide evolve-on Lagrangian-in-chart
         trajectory-point trajectory-chart-changes
         follow-in-charts)

;; ---------------------------------------------------------------------------
;; The same Lagrangian in another chart

;; L : in the chart C -> in B
(define (Lagrangian-in-chart L C B)
  (define who 'Lagrangian-in-chart)
  (check-argument who procedure? L "a Lagrangian, a function of the local tuple")
  (check-coordinate-system who C)
  (check-coordinate-system who B)
  (cond [(same-chart? C B) L]
        [else
         (define carried (compose L (F->C (transition B C))))
         (or (if-raised refusal? #f (as-formula carried B)) carried)]))

;; local tuple in B -> coordinates in C
(define ((transition B C) local)
  (coordinates-in C ((point B) (coordinate local))))

;; The function, simplified at symbols
(define (as-formula f B)
  (define q (coordinate-tuple (coordinate-system-symbols B)))
  (define place (up (string->uninterned-symbol "t") q (symbols-like q "v")))
  (define e (simplify-strictly (f place)))
  (lambda (local) (evaluate-at e place local)))

;; ---------------------------------------------------------------------------
;; The trajectory

;; stretches : list of stretch, in their order;  home : chart
(value-struct manifold-trajectory trajectory (stretches home))

;; What was followed in one chart;  reference : home coordinates at its start
(struct stretch (chart trajectory reference) #:authentic)

(define a-motion "a motion on a manifold, such as evolve-on gives")

;; The point of the manifold at a time
(define (trajectory-point tr t)
  (check-argument 'trajectory-point manifold-trajectory? tr a-motion)
  (define s (stretch-at (manifold-trajectory-stretches tr) t))
  ((point (stretch-chart s)) (coordinate ((stretch-trajectory s) t))))

(define (stretch-at stretches t)
  (or (for/first ([s (in-list stretches)]
                  #:when (between? (trajectory-start (stretch-trajectory s)) t
                                   (trajectory-end (stretch-trajectory s))))
        s)
      (last stretches)))

;; -> a list of (time from to)
(define (trajectory-chart-changes tr)
  (check-argument 'trajectory-chart-changes manifold-trajectory? tr a-motion)
  (define stretches (manifold-trajectory-stretches tr))
  (for/list ([a (in-list stretches)] [b (in-list (cdr stretches))])
    (list (trajectory-start (stretch-trajectory b)) (stretch-chart a) (stretch-chart b))))

;; ---------------------------------------------------------------------------
;; Following one

;; A chart is left when its fitness falls to this part of that at the start of the stretch.
(define much-less 0.1)

;; L : a Lagrangian in the chart C, the home;  state : (up t q v) there, or with a point for q and
;; the velocity in the point's chart
(define-plain (evolve-on L C state end
                         #:events [events '()] #:charts [charts #f]
                         #:tolerance [tolerance #f] #:method [method #f]
                         #:longest-step [longest +inf.0])
  (define who 'evolve-on)
  (check-coordinate-system who C)
  (check-argument who procedure? L "a Lagrangian, a function of the local tuple")
  (define (rates B) (Lagrangian->state-derivative (Lagrangian-in-chart L C B)))
  (follow-in-charts who rates C state end events charts tolerance method longest))

;; rates-in : chart -> state derivative there
(define (follow-in-charts who rates-in C state end events charts tolerance method longest)
  (check-method who method)
  (define all-charts (check-charts who (or charts (manifold-charts (coordinate-system-manifold C)))
                                   C))
  (define all-events (check-events who events))
  (define-values (B start) (start-in who C state))
  (define rates (once-a-chart rates-in))
  (define (follow B start reference leave)
    (evolve-trajectory (rates B) start end
                       #:events (append leave (translated all-events B C reference))
                       #:tolerance tolerance #:method method #:longest-step longest))
  (assembled (stretches-of follow all-charts C B start end) C all-events))

;; -> list of stretches
(define (stretches-of follow charts home B start end)
  (let loop ([B B] [start start] [reference (home-coordinates home B start #f)] [done '()])
    (define leave (leaving-event B start))
    (define tr (follow B start reference leave))
    (define here (cons (stretch B tr reference) done))
    (cond [(not (left? tr leave)) (reverse here)]
          [else
           (define at (trajectory-final-state tr))
           (define next (next-chart B at charts))
           (define q (home-coordinates home B at (home-before (car here) home at)))
           (cond [next (loop next (state-in next B at (and (same-chart? next home) q)) q here)]
                 [else
                  (define rest (follow B at q '()))
                  (reverse (cons (stretch B rest q) here))])])))

(define (leaving-event B start)
  (define fitness (chart-fitness B))
  (define limit (* much-less (fitness (coordinate start))))
  (list (event (lambda (local) (g:- (fitness (coordinate local)) limit))
               #:name 'chart-left #:direction 'falling #:terminal? #t)))

(define (left? tr leave)
  (define found (trajectory-events tr))
  (and (pair? found) (eq? (occurrence-event (last found)) (car leave))))

;; The fittest chart, if it is fitter than B
(define (next-chart B state charts)
  (define m ((point B) (coordinate state)))
  (define-values (best fitness) (fittest-chart charts m))
  (and best (not (same-chart? best B))
       (> fitness (* 2 ((chart-fitness B) (coordinate state))))
       best))

;; The state in the chart `to`, with the coordinates q if they are given
(define (state-in to from state [q #f])
  (define there ((F->C (transition from to)) state))
  (if q (up (time there) q (velocity there)) there))

;; ---------------------------------------------------------------------------
;; Home coordinates: angles are those next to a reference

(define (home-coordinates home B state reference)
  (define q (if (same-chart? B home) (coordinate state) ((transition B home) state)))
  (if reference (next-to reference q home) q))

(define (next-to reference q home)
  (define periods (vector->list (coordinate-periods home)))
  (define xs
    (for/list ([x (in-list (scalars q))] [r (in-list (scalars reference))] [p (in-list periods)])
      (if p (g:+ r (angle-between r x)) x)))
  (list->structure q xs))

;; x − r, between −π and π.  Half a turn, as through a pole, is taken towards 0, so that a motion
;; to and fro through it counts no turns.
(define (angle-between r x)
  (define d (g:- x r))
  (cond [(real? d)
         (define short (- d (* 2 pi (round (/ d (* 2 pi))))))
         (if (and (> (abs short) (- pi 1e-6)) (> (* r short) 0))
             (- short (* 2 pi (sgn short)))
             short)]
        [else (g:atan (g:sin d) (g:cos d))]))

;; The home coordinates where the stretch ends, by steps small enough to follow the angles
(define (home-before s home state)
  (if (same-chart? (stretch-chart s) home)
      (coordinate state)
      ((home-follower s home) (time state))))

;; A function of the time: home coordinates, followed from the start of the stretch
(define (home-follower s home)
  (define tr (stretch-trajectory s))
  (define B (stretch-chart s))
  (define (near t reference) (home-coordinates home B (tr t) reference))
  (define nodes
    (for/fold ([nodes (list (cons (trajectory-start tr) (stretch-reference s)))])
              ([t (in-list (sampled-times tr))])
      (cons (cons t (near t (cdar nodes))) nodes)))
  (define forth? (<= (trajectory-start tr) (trajectory-end tr)))
  (lambda (t)
    (define before
      (or (for/first ([n (in-list nodes)] #:when (if forth? (<= (car n) t) (>= (car n) t))) n)
          (last nodes)))
    (near t (cdr before))))

;; Eight to a step
(define (sampled-times tr)
  (define times (map time (trajectory-states tr)))
  (append* (for/list ([a (in-list times)] [b (in-list (cdr times))])
             (for/list ([k (in-range 1 9)]) (+ a (* (/ k 8) (- b a)))))))

;; ---------------------------------------------------------------------------
;; Events: of functions on the manifold, or of the state at home

(define (translated events B home reference)
  (for/list ([e (in-list events)])
    (define f (event-f e))
    (event (cond [(manifold-function? f) (lambda (local) (f ((point B) (coordinate local))))]
                 [(same-chart? B home) f]
                 [else (lambda (local) (f (home-state home B local reference)))])
           #:name (event-name e) #:direction (event-direction e)
           #:terminal? (event-terminal? e))))

(define (home-state home B local reference)
  (if (same-chart? B home)
      local
      (let ([there ((F->C (transition B home)) local)])
        (up (time there) (next-to reference (coordinate there) home) (velocity there)))))

;; ---------------------------------------------------------------------------
;; One trajectory of them all

(define (assembled stretches home events)
  (define parts
    (for/list ([s (in-list stretches)]) (at-home s home events)))
  (define reading-at-home
    (reading real->double-flonum values (lambda (s t) ((step-inside s) t))))
  (manifold-trajectory (list->vector (append-map car parts)) (append-map cdr parts)
                       reading-at-home
                       (trajectory-method (stretch-trajectory (last stretches)))
                       stretches home))

;; -> the steps, and the occurrences, in home coordinates
(define (at-home s home events)
  (define tr (stretch-trajectory s))
  (define B (stretch-chart s))
  (define q (if (same-chart? B home) #f (home-follower s home)))
  (define (state t)
    (define local (tr t))
    (if q (home-state home B local (q t)) local))
  (define times (map time (trajectory-states tr)))
  (cons (for/list ([a (in-list times)] [b (in-list (append (cdr times) (take-right times 1)))]
                   #:unless (and (= a b) (pair? (cdr times))))
          (step a b state b))
        (filter-map (lambda (o) (occurrence-at-home o state events)) (trajectory-events tr))))

;; An angle that comes round where a chart counts it anew is no event: its function is not 0 there.
(define (occurrence-at-home o state events)
  (define e (findf (lambda (e) (eq? (event-name e) (event-name (occurrence-event o)))) events))
  (define there (and e (state (occurrence-time o))))
  (and e
       (or (manifold-function? (event-f e))
           (< (abs ((event-f e) there)) 1e-3))
       (occurrence e (occurrence-time o) there (occurrence-grazing? o))))

;; ---------------------------------------------------------------------------
;; What is given

(define (start-in who C state)
  (unless (and (up? state) (= (structure-length (adopt state)) 3))
    (complain-of-argument who "a state (up t q v), or (up t point v)" state))
  (define q (coordinate state))
  (cond [(point? q)
         (unless (eq? (coordinate-system-manifold (point-system q)) (coordinate-system-manifold C))
           (check-point q (coordinate-system-manifold C)))
         (values (point-system q) (up (time state) (point-coordinates q) (velocity state)))]
        [else (values C state)]))

(define (check-charts who charts C)
  (check-argument who (lambda (cs) (and (list? cs) (pair? cs) (andmap coordinate-system? cs)))
                  charts "a list of charts")
  (for ([B (in-list charts)])
    (unless (eq? (coordinate-system-manifold B) (coordinate-system-manifold C))
      (complain-showing who "the charts are of different manifolds" "chart" B "home" C)))
  charts)

(define (check-method who method)
  (when (and method (not (memq method own-steps)))
    (complain-showing who (string-append "a change of charts needs a method that chooses its steps;"
                                         " symplectic methods keep theirs")
                      "method" method)))

(define own-steps
  '(auto Taylor Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5))
