#lang racket/base
;; Orbits of a map, computed by a thread of their own while a window goes on.
;;
;; The thread takes the orbits in turn, a few hundredths of a second each, and hands on the points
;; of each turn; it does not begin the next before they have been received.  So many orbits
;; grow side by side, and a window that is slow to draw is not flooded.

(require racket/flonum
         (only-in "../../error/refusal.rkt" raised?)
         "../../generic/on-demand.rkt")

(require-on-demand ["../../dynamics/map/compiled-map.rkt" stepper-at])

(provide start-worker ask-worker stop-worker
         make-orbit orbit-color orbit-start orbit-stopped? stop-orbit!)

;; color : a number; start : (cons x y); at : the present point, an flvector; step! : moves `at`;
;; made by the worker
(struct orbit (color start at [step! #:mutable] [stopped? #:mutable])
  #:authentic)

(define (make-orbit color x y) (orbit color (cons x y) (flvector x y) #f #f))
(define (stop-orbit! o) (set-orbit-stopped?! o #t))

(struct worker (thread custodian))

;; receive : orbit, two flvectors, of abscissas and of ordinates, how many of them count, a text
;; that says why there are no more, or #f -> any; it is called in the worker's thread
(define (start-worker map receive)
  (define custodian (make-custodian))
  (worker (parameterize ([current-custodian custodian])
            (thread (lambda () (work map receive))))
          custodian))

;; n further points of an orbit
(define (ask-worker w o n) (thread-send (worker-thread w) (job o n) void))

(define (stop-worker w) (custodian-shutdown-all (worker-custodian w)))

;; ---------------------------------------------------------------------------

(struct job (orbit left))

(define (work map receive)
  (let loop ([jobs '()])
    (define new (if (null? jobs) (thread-receive) (thread-try-receive)))
    (cond [new (loop (append jobs (list new)))]
          [else
           (define left (take-turn map (car jobs) receive))
           (loop (if left (append (cdr jobs) (list left)) (cdr jobs)))])))

(define turn 30.0)               ; milliseconds
(define most 8192)               ; points in a turn

;; -> the rest of the job, or #f.  An exception raised by the reader's map ends its orbit.
(define (take-turn map j receive)
  (define o (job-orbit j))
  (define-values (xs ys) (values (make-flvector most) (make-flvector most)))
  (define count 0)
  (define (add! at)
    (flvector-set! xs count (flvector-ref at 0))
    (flvector-set! ys count (flvector-ref at 1))
    (set! count (+ count 1)))
  (define (finish why left)
    (receive o xs ys count why)
    left)
  (define (said e) (if (exn? e) (exn-message e) (format "the map raises ~v" e)))
  (with-handlers ([raised? (lambda (e) (finish (said e) #f))])
    (define begun? (orbit-step! o))
    (define step! (or begun? (begin-orbit map o)))
    (cond [(not step!) (finish "no image" #f)]
          [else
           (unless begun? (add! (orbit-at o)))
           (define-values (left ended?) (advance o step! (job-left j) add!))
           (finish (and ended? "no further image")
                   (and (> left 0) (not ended?) (not (orbit-stopped? o)) (job o left)))])))

;; -> step!, or #f if the map has no image of the start
(define (begin-orbit map o)
  (define step! (stepper-at 'explore-map map (car (orbit-start o)) (cdr (orbit-start o))))
  (set-orbit-step!! o step!)
  step!)

;; -> the number of points left when the turn is over, and whether the orbit has ended
(define (advance o step! n add!)
  (define end (+ (current-inexact-milliseconds) turn))
  (let loop ([left n] [room (- most 1)])
    (cond [(or (= left 0) (= room 0) (orbit-stopped? o)
               (and (eqv? 0 (bitwise-and left 15)) (> (current-inexact-milliseconds) end)))
           (values left #f)]
          [(step! (orbit-at o))
           (add! (orbit-at o))
           (loop (- left 1) (- room 1))]
          [else (values 0 #t)])))
