#lang racket/base
;; Motions on a manifold: charts are changed before one becomes singular.
;;
;; The motion is followed in one chart until that is much less fit than where the stretch began,
;; and goes on in the fittest one.  States, events and all else that is asked of the trajectory are
;; those of its home chart, with angles that do not jump.

(require racket/flonum
         racket/list
         racket/vector
         "chart-choice.rkt" "continuous-angles.rkt" "event-on-manifold.rkt"
         "Lagrangian-in-chart.rkt" "../manifold-chart.rkt"
         "../manifold-point.rkt" "motion-stretch.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/up-down.rkt"
         "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../lagrangian/coordinate-transformation.rkt" "../../lagrangian/local-tuple.rkt"
         "../../lagrangian/state-derivative.rkt"
         "../../motion/event/event.rkt" "../../motion/event/region-watch.rkt"
         "../../motion/evolve-trajectory.rkt"
         "../../motion/integration-failure.rkt" "../../motion/integration-plan.rkt"
         "../../motion/method-names.rkt" "../../motion/observed-systems.rkt"
         "../../motion/partial-result.rkt" "../../motion/system/check.rkt"
         "../../motion/trajectory.rkt"
         "../../value/shape.rkt")

(provide evolve-on
         trajectory-point trajectory-momentum trajectory-chart-changes
         follow-in-charts check-steps manifold-trajectory? manifold-trajectory-stretches)

;; ---------------------------------------------------------------------------
;; The trajectory

;; stretches : vector of stretch, in their order;  home : chart
;; L-in : chart -> Lagrangian, or #f
(value-struct manifold-trajectory trajectory (stretches home L-in))

(define (check-motion who tr)
  (check-argument who manifold-trajectory? tr "a motion on a manifold, such as evolve-on gives"))

;; The point of the manifold at a time
(define (trajectory-point tr t)
  (check-motion 'trajectory-point tr)
  (define s (stretch-at 'trajectory-point tr t))
  ((point (stretch-chart s)) (coordinate (local-state-at s t))))

;; The momenta of the coordinates at home
(define (trajectory-momentum tr t)
  (check-motion 'trajectory-momentum tr)
  (define L-in (manifold-trajectory-L-in tr))
  (unless L-in
    (complain 'trajectory-momentum
              "the geodesics of a connection have no Lagrangian; those of a metric do"))
  (define s (stretch-at 'trajectory-momentum tr t))
  (momentum-at-home (L-in (stretch-chart s)) (stretch-chart s) (local-state-at s t)
                    (stretch-home s) (home-coordinates-at s t)))

;; The stretch that holds the time
(define (stretch-at who tr t)
  (check-real who "time" t)
  (unless (between? (trajectory-start tr) t (trajectory-end tr)) (raise-outside who tr t))
  (stretch-of (manifold-trajectory-stretches tr) t))

;; Bisection
(define (stretch-of stretches t)
  (define first-time (stretch-start (vector-ref stretches 0)))
  (let search ([low 0] [high (vector-length stretches)])
    (define middle (quotient (+ low high) 2))
    (cond [(= middle low) (vector-ref stretches low)]
          [(between? first-time (stretch-start (vector-ref stretches middle)) t)
           (search middle high)]
          [else (search low middle)])))

;; -> a list of (time from to)
(define (trajectory-chart-changes tr)
  (check-motion 'trajectory-chart-changes tr)
  (define stretches (vector->list (manifold-trajectory-stretches tr)))
  (for/list ([a (in-list stretches)] [b (in-list (cdr stretches))]
             #:unless (same-chart? (stretch-chart a) (stretch-chart b)))
    (list (stretch-end a) (stretch-chart a) (stretch-chart b))))

;; ---------------------------------------------------------------------------
;; Following one

;; L : a Lagrangian in the chart C, the home, or a list of (list chart Lagrangian)
;; state : (up t q v) there, or with a point for q and the velocity in the point's chart
(define-plain (evolve-on L C state end
                         #:events [events '()] #:charts [charts #f]
                         #:tolerance [tolerance #f] #:method [method #f]
                         #:longest-step [longest +inf.0])
  (define who 'evolve-on)
  (check-coordinate-system who C)
  (define L-in (Lagrangian-by-charts who L C))
  (follow-in-charts who (lambda (B) (Lagrangian->state-derivative (L-in B))) C state end
                    events charts (make-plan who tolerance (check-steps who method) longest)
                    #:Lagrangian L-in #:agreeing? (list? L)))

;; The question.  ways : chart, state there -> passage to home;  check : of two stretches
(struct request (plan rates-in home ways events charts end L-in agreeing?) #:authentic)

;; rates-in : chart -> state derivative there
;; agreeing? : are the Lagrangians of charts to be compared?
(define (follow-in-charts who rates-in C state end events charts plan
                          #:Lagrangian [L-in #f] #:agreeing? [agreeing? #f])
  (check-real who "final time" end)
  (define all-charts
    (check-charts who (or charts (manifold-charts (coordinate-system-manifold C))) C))
  (define rates (once-a-chart rates-in))
  (define r (request plan rates C (passages-to C) (check-events who events) all-charts end
                     L-in agreeing?))
  (define-values (B start) (start-in who C state))
  (note-followed (rates B) '() start)
  (define way ((request-ways r) B start))
  (assembled r (stretches-from r B start ((passage-coordinates way) start) '())))

;; done : the stretches before, the last one first -> all
(define (stretches-from r B start q done)
  (define-values (s failure) (next-stretch r B start q done))
  (define here (cons s done))
  (cond [(or (ended-by-event? s) (and (not failure) (over? s))) (reverse here)]
        [else
         (define at (local-state-at s (stretch-end s)))
         (define home-q (home-coordinates-at s (stretch-end s)))
         (define next (if failure (way-out-of failure s r at) (next-chart B at (request-charts r))))
         (define there (if next (state-in next B at (request-home r) home-q) at))
         (when (and next (request-agreeing? r))
           (check-agreement (who-of r) (request-L-in r) B at next there))
         (stretches-from r (or next B) there home-q here)]))

(define (who-of r) (plan-who (request-plan r)))

;; -> a stretch, and the failure that ended it or #f
(define (next-stretch r B start q done)
  (define events (request-events r))
  (define watched (watched-in events B (request-home r)))
  (define way ((request-ways r) B start))
  (define (assembled-so-far tr) (assembled r (reverse (cons (make-stretch way tr q) done))))
  (define-values (tr failure)
    (with-handlers ([cut-short? (lambda (e) (values (last-part e) e))])
      (values (flonum-trajectory (request-plan r) ((request-rates-in r) B) start (request-end r)
                                 (map car watched) (fit-region way start assembled-so-far))
              #f)))
  (define all
    (keeping-so-far (lambda () (assembled-so-far tr))
      (with-occurrences (who-of r) (make-stretch way tr q) events watched
                        (plan-tolerance (request-plan r)))))
  (define s (if (and failure (not (ended-by-event? all))) (shortened all) all))
  (values (if (null? done) s (settled (who-of r) (car done) s events)) failure))

;; The trajectory in the chart where the integration failed
(define (last-part e)
  (define stretches (manifold-trajectory-stretches (trajectory-so-far e)))
  (stretch-trajectory (vector-ref stretches (sub1 (vector-length stretches)))))

;; Without its last part, where the steps became short and digits were lost
(define (shortened s)
  (define end (+ (stretch-start s) (* 0.9 (- (stretch-end s) (stretch-start s)))))
  (cut-at s end (filter (lambda (o) (between? (stretch-start s) (occurrence-time o) end))
                        (stretch-occurrences s))))

;; Coordinates may end where the fitness of the chart does not show it, as x and y do at the equator
;; of a sphere.  Then another chart is tried, if the motion went on at all.
(define (way-out-of failure s r at)
  (define B (stretch-chart s))
  (define others (filter (lambda (C) (not (same-chart? B C))) (request-charts r)))
  (define-values (best fitness)
    (fittest-chart others ((point B) (coordinate at))))
  (if (and best (not (= (stretch-start s) (stretch-end s)))) best (raise failure)))

;; A chart is left when its fitness falls to this part of that at the start of the stretch.
(define much-less 0.1)

(define chart-left (event coordinate #:name 'chart-left #:terminal? #t))

(define (fit-region way start whole)
  (define look (passage-fitness way))
  (define seen (make-flvector 2))
  (look (structure->flvector start void) seen)
  (region look (* much-less (flvector-ref seen 0)) chart-left whole))

(define (over? s) (not (eq? (last-event (trajectory-events (stretch-trajectory s))) chart-left)))
(define (ended-by-event? s)
  (define e (last-event (stretch-occurrences s)))
  (and e (event-terminal? e)))
(define (last-event os) (and (pair? os) (occurrence-event (last os))))

;; The fittest chart, if it is fitter than B
(define (next-chart B state charts)
  (define m ((point B) (coordinate state)))
  (define-values (best fitness) (fittest-chart charts m))
  (and best (not (same-chart? best B))
       (> fitness (* 2 ((chart-fitness B) (coordinate state))))
       best))

;; The state in the chart `to`; at home, with the coordinates q
(define (state-in to from state home q)
  (define there ((F->C (transition from to)) state))
  (if (same-chart? to home) (up (time there) q (velocity there)) there))

;; ---------------------------------------------------------------------------
;; One trajectory of all stretches, whose states are those at home

(define (assembled r stretches)
  (define all (list->vector stretches))
  (define first-tr (stretch-trajectory (car stretches)))
  (define steps (if (null? (cdr stretches)) (steps-of (car stretches))
                    (apply vector-append (map steps-of stretches))))
  (manifold-trajectory steps (append-map stretch-occurrences stretches)
                       (reading real->double-flonum values
                                (lambda (s t) (home-state-at (stretch-of all t) t)))
                       (trajectory-method first-tr)
                       all (request-home r) (request-L-in r)))

;; Up to where the stretch ends
(define (steps-of s)
  (define steps (trajectory-steps (stretch-trajectory s)))
  (define end (stretch-end s))
  (define count
    (for/sum ([one (in-vector steps 1)]
              #:break (between? (stretch-start s) end (step-from one)))
      1))
  (vector-append (vector-take steps count)
                 (vector (struct-copy step (vector-ref steps count) [to end]))))

;; ---------------------------------------------------------------------------
;; The arguments

(define (start-in who C state)
  (unless (and (up? state) (= (structure-length (adopt state)) 3))
    (complain-of-argument who "a state (up t q v), or (up t point v)" state))
  (define q (coordinate state))
  (cond [(point? q)
         (check-point q (coordinate-system-manifold C))
         (values (point-system q)
                 (regular who (point-system q)
                          (up (time state) (point-coordinates q) (velocity state))))]
        [else (values C (regular who C state))]))

;; The state, if the chart B has such a place and is regular there
(define (regular who B state)
  (define-values (q v) (values (coordinate state) (velocity state)))
  (unless (same-shape? q (coordinate-tuple (coordinate-system-symbols B)))
    (complain-showing who "the state has other coordinates than the chart"
                      "chart" B "coordinates" q))
  (unless (same-shape? q v)
    (complain-showing who "the velocities are not of the shape of the coordinates"
                      "coordinates" q "velocities" v))
  (state-vector who state)
  (unless (own-coordinates? B q)
    (complain-showing who (string-append "the start is outside the chart, or where it is singular"
                                         "\n  a point may stand for the coordinates, with velocities"
                                         " in its chart: (up t point v)")
                      "chart" B "coordinates" q))
  state)

(define (check-charts who charts C)
  (check-argument who (lambda (cs) (and (list? cs) (pair? cs) (andmap coordinate-system? cs)))
                  charts "a list of charts")
  (for ([B (in-list charts)]) (check-one-manifold who C B))
  charts)

;; The method, if it chooses its steps
(define (check-steps who method)
  (define m (or method (ode-integration-method)))
  (when (and (integration-method? m) (not (symbol? m)))
    (complain-showing who (string-append "a change of charts needs a method that chooses its steps;"
                                         " symplectic methods keep theirs")
                      "method" m))
  (when (ode-precision)
    (complain who "motions whose charts change are followed in flonums; (ode-precision) is ~a"
              (ode-precision)))
  method)
