#lang racket/base
;; Events along a motion whose charts change: each is found once.
;;
;; An event is a function on the manifold, or one of the state in the home chart.  The first kind is
;; watched in whatever chart the motion is followed; the second where this is the home chart.
;; Elsewhere the state at home is read with angles that do not jump, and zeros are looked for
;; between times that are near enough to each other.  Where one stretch of the motion ends and
;; the next begins, rounding may lose a zero or give it twice: signs beside the place decide.

(require racket/flonum
         racket/list
         "continuous-angles.rkt" "../manifold-chart.rkt" "../manifold-function.rkt"
         "../manifold-point.rkt"
         "motion-stretch.rkt"
         "../../error/complain.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../motion/event/event.rkt" "../../motion/event/event-noise.rkt"
         "../../motion/event/sign-change.rkt" "../../motion/trajectory.rkt"
         "../../value/shape.rkt")

(provide watched-in with-occurrences settled)

;; ---------------------------------------------------------------------------
;; Watched by the integration

;; -> a list of (event watched in the chart B . event), of those that can be
(define (watched-in events B home)
  (for/list ([e (in-list events)] #:when (or (on-manifold? e) (same-chart? B home)))
    (define f (event-f e))
    (cons (event (if (on-manifold? e) (lambda (local) (f ((point B) (coordinate local)))) f)
                 #:name (event-name e) #:direction (event-direction e)
                 #:terminal? (event-terminal? e))
          e)))

(define (on-manifold? e) (manifold-function? (event-f e)))

;; The stretch with all that occurs on it, up to where that ends it.
;; watched : the list above
(define (with-occurrences who s events watched tolerance)
  (define found
    (for*/list ([o (in-list (trajectory-events (stretch-trajectory s)))]
                [own (in-value (assq (occurrence-event o) watched))]
                #:when own)
      (at-home s (cdr own) (occurrence-time o) (occurrence-grazing? o))))
  (define others
    (append-map (lambda (e) (zeros-on who s e tolerance))
                (for/list ([e (in-list events)] #:unless (memq e (map cdr watched))) e)))
  (ended s (in-order s (append found others))))

(define (at-home s e t [grazing? #f]) (occurrence e t (home-state-at s t) grazing?))

(define (in-order s occurrences)
  (sort occurrences (if (forth? s) < >) #:key occurrence-time))

(define (forth? s)
  (<= (stretch-start s) (trajectory-end (stretch-trajectory s))))

;; Up to the first that is terminal
(define (ended s occurrences)
  (let loop ([left occurrences] [kept '()])
    (cond [(null? left) (cut-at s (stretch-end s) (reverse kept))]
          [(event-terminal? (occurrence-event (car left)))
           (cut-at s (occurrence-time (car left)) (reverse (cons (car left) kept)))]
          [else (loop (cdr left) (cons (car left) kept))])))

;; ---------------------------------------------------------------------------
;; Looked for afterwards, in home coordinates where the motion is followed in another chart

(define (zeros-on who s e tolerance)
  (define nodes (stretch-nodes s))
  (define (g t) (value-at who s e t))
  (define values (for/list ([n (in-list nodes)]) (g (node-time n))))
  (define size (apply max (map abs values)))
  (check-jumps who s e nodes values size)
  (define found
    (append*
     (for/list ([a (in-list nodes)] [ga (in-list values)]
                [b (in-list (cdr nodes))] [gb (in-list (cdr values))])
       (zeros-between g (node-time a) ga (node-time b) gb (event-direction e) 10))))
  (if (and (pair? found) (noise? size (change-by-errors who s e nodes tolerance)))
      '()
      (for/list ([t (in-list found)]) (at-home s e t))))

;; Times in the part from a to b, in which g is taken for a parabola if its value in the middle is
;; near to the mean of those at the ends.
(define (zeros-between g a ga b gb direction halvings)
  (define m (/ (+ a b) 2))
  (define gm (g m))
  (define bend (abs (- gm (/ (+ ga gb) 2))))
  (cond [(< (* 2 bend) (min (abs ga) (abs gb) (if (> (* ga gb) 0) (abs gm) 0))) '()]
        [(or (zero? halvings) (and (<= (* ga gb) 0) (< (* 4 bend) (abs (- gb ga)))))
         (define zero
           (and (crosses? ga gb direction)
                (zero-between g a ga b gb #:near (* 1e-15 (max (abs a) (abs b))))))
         (if zero (list zero) '())]
        [else (append (zeros-between g a ga m gm direction (sub1 halvings))
                      (zeros-between g m gm b gb direction (sub1 halvings)))]))

(define (value-at who s e t)
  (define x
    (if (on-manifold? e)
        ((event-f e) ((point (stretch-chart s)) (coordinate (local-state-at s t))))
        (event-value who e (home-state-at s t))))
  (if (real? x)
      x
      (raise-undefined e t (home-state-at s t) (stretch-trajectory s) who)))

;; A function of coordinates that jumps where these are singular is no event.
(define (check-jumps who s e nodes values size)
  (for ([n (in-list (cdr nodes))] [before (in-list values)] [after (in-list (cdr values))]
        #:when (and (node-jump? n) (> (abs (- after before)) (* 1e-6 size))))
    (complain-showing
     who (string-append "an event is in coordinates that are singular where the motion passes"
                        "\n  make it a function on the manifold, such as the coordinates of another"
                        " chart")
     "event" e
     "coordinates" (stretch-home s)
     "time" (node-time n))))

;; The most by which errors of the state change the function
(define (change-by-errors who s e nodes tolerance)
  (for/fold ([most 0.0]) ([n (in-list nodes)])
    (define state (home-state-at s (node-time n)))
    (define point (structure->flvector state void))
    (vary-point! point (make-flvector (flvector-length point) tolerance))
    (define x (event-value who e (flvector->structure state point)))
    (if (real? x) (max most (abs (- x (value-at who s e (node-time n))))) most)))

;; ---------------------------------------------------------------------------
;; Where one stretch ends and the next begins

;; The stretch, with each event once that occurs where the stretch before it ended
(define (settled who before s events)
  (define at (stretch-end before))
  (define by (* 1e-9 (- (stretch-end s) at)))
  (define (near? o) (<= (abs (- (occurrence-time o) at)) (abs by)))
  (define (near e stretch)
    (for/list ([o (in-list (stretch-occurrences stretch))]
               #:when (and (near? o) (eq? (occurrence-event o) e)))
      o))
  (for/fold ([s s]) ([e (in-list events)])
    (define crossed?
      (crosses? (value-at who before e (- at (earlier before by))) (value-at who s e (+ at by))
                (event-direction e)))
    (define-values (earlier-ones later-ones) (values (near e before) (near e s)))
    (cond [(and crossed? (null? earlier-ones) (null? later-ones))
           (ended s (in-order s (cons (at-home s e at) (stretch-occurrences s))))]
          [(and crossed? (pair? earlier-ones) (pair? later-ones))
           (cut-at s (stretch-end s) (remq* later-ones (stretch-occurrences s)))]
          [else s])))

;; No more than the length of the stretch
(define (earlier s by)
  (define length (- (stretch-end s) (stretch-start s)))
  (if (< (abs length) (abs by)) length by))
