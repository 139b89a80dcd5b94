#lang racket/base
;; Animations: a motion, and how its states are drawn.
;;
;; An animation is a value: nothing is drawn before somebody asks for a picture, a file or a
;; window.  Parts that take time to find, such as the curves of trails, are found once.

(require file/convertible
         "drawing.rkt" "film.rkt" "on-demand.rkt" "phase-plane.rkt" "pictures-on-demand.rkt"
         "../display/picture-advice.rkt"
         "../../error/complain.rkt" "../../error/computed-once.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/on-demand.rkt"
         "../plot/plotted-number.rkt")

(provide animate animation? check-animation animation-film animation-pictures)

;; pictures : -> scenery.rkt's scenery, made once
(value-struct animation (film pictures)
  #:datum (lambda (a) (film->datum (animation-film a)))
  #:constructor-name new-animation
  #:omit-define-syntaxes
  #:property prop:advice
  (lambda (a)
    (string-append "to see an animation a: (animation-show a), or (animation-save a \"motion.gif\")"
                   " or \"motion.html\""))
  #:property prop:convertible
  (lambda (a request default)
    (cond [(eq? request 'text) (value->text (film->datum (animation-film a)))]
          [(why-no-pictures) default]
          [else (convert-scenery ((animation-pictures a)) request default)])))

(define (film->datum f)
  (define s (film-schedule f))
  (define drawing (film-drawing f))
  `(animation from ,(schedule-from s) to ,(schedule-to s) of
              ,(if (drawing? drawing) (drawing-datum drawing) (procedure-datum drawing))))

(define (check-animation who a)
  (check-argument who animation? a "an animation, such as (animate trajectory (draw-pendulum))"))

;; ---------------------------------------------------------------------------
;; Making one

(define (animate motion drawing #:from [from #f] #:to [to #f]
                 #:speed [speed 1] #:frames-per-second [rate 25]
                 #:trail [trail #f] #:trail-time [trail-time #f]
                 #:phase-portrait [portrait #f] #:title [title "Motion"])
  (define who 'animate)
  (check-motion who motion from to)
  (check-function who drawing 1
                  "a drawing, a function from states to picts, such as (draw-pendulum)")
  (check-argument who string? title "a string as title")

  (when trail-time
    (unless (> (check-number who "the time of the trail" trail-time) 0.0)
      (complain-of-argument who "a positive time of the trail, or #f" trail-time)))
  (define s (if (trajectory? motion)
                (make-schedule who (or from (trajectory-start motion))
                               (or to (trajectory-end motion)) speed rate)
                (make-schedule who from to speed rate)))
  (define first (motion (schedule-time s 0)))
  (motion (schedule-time s (- (schedule-count s) 1)))
  (check-first who drawing first)
  (define f
    (film motion drawing s (trail-of who trail drawing first) trail-time
          (plane-of who portrait drawing first) title))
  (new-animation f (once (lambda () (make-scenery f)))))

(define (check-motion who motion from to)
  (cond [(trajectory? motion) (void)]
        [(not (and (procedure? motion) (accepts? motion 1)))
         (complain who
                   (string-append "expected a trajectory, such as evolve-trajectory gives, "
                                  "or a function from the time to states\n  given: ~a")
                   (describe-with-value motion))]
        [(not (and from to))
         (complain who "a function of the time has no beginning and no end; say #:from and #:to")]))

;; A drawing of the library tells which states it draws; of another one its picture is made.
(define (check-first who drawing state)
  (if (drawing? drawing)
      (check-state drawing state)
      (begin (check-drawing-library who)
             (check-picture who (drawing state) state)))
  (void))

;; -> state -> points, or #f
(define (trail-of who trail drawing first)
  (define own (and (drawing? drawing) (drawing-trail drawing)))
  (cond [(not trail) #f]
        [(eq? trail #t)
         (or own
             (complain who "this drawing does not say which point leaves a trail\n  ~a"
                       "#:trail takes a function from states to points, too"))]
        [(and (procedure? trail) (accepts? trail 1))
         (define (points state) (trail-points who (trail state)))
         (points first)
         points]
        [else
         (complain-of-argument who "#t, #f, or a function from states to points, as trail" trail)]))

(define (plane-of who portrait drawing first)
  (define names (if (drawing? drawing) (drawing-axes drawing) '()))
  (define plane
    (cond [(not portrait) #f]
          [(phase-plane? portrait) portrait]
          [(eq? portrait #t) (plane-of-coordinate who 0 names first)]
          [(exact-nonnegative-integer? portrait) (plane-of-coordinate who portrait names first)]
          [else
           (complain-of-argument
            who "#t, #f, the number of a coordinate, or a phase-plane, as phase portrait"
            portrait)]))
  (when plane (plane-point-at plane who first))
  plane)
