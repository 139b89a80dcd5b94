#lang racket/base
;; One measurement in a process of its own:  racket child.rkt NAME
;;
;; Writes (milliseconds size) for a task, and nanoseconds per operation, ours
;; and Racket's own, for a micro task.

(require "clock.rkt" "task.rkt" "tasks.rkt")

;; Rooms loaded on demand are loaded before the clock starts.
(define (load-rooms)
  (for ([file (in-list '(algebra/elimination/characteristic algebra/elimination/elimination
                         algebra/rewriting/apart algebra/rewriting/collect
                         algebra/rewriting/expand algebra/rewriting/factor
                         algebra/zero/common-domain algebra/zero/zero-test
                         calculus/integral
                         compile/compile-function
                         dynamics/map/iterated-map
                         motion/evolution motion/evolve-trajectory motion/find-path))])
    (dynamic-require (string->symbol (format "mechanics/~a" file)) #f)))

(define (measure-task t)
  (load-rooms)
  (define prepared ((task-prepare t)))
  (define-values (result time) (call/cpu (lambda () ((task-run t) prepared))))
  (list time (and (task-size t) ((task-size t) result))))

(define (measure-micro m)
  (list (nanoseconds (micro-run m))
        (and (micro-baseline m) (nanoseconds (micro-baseline m)))))

;; Enough operations to take a while, best of several.
(define (nanoseconds run)
  (define count
    (let loop ([n 1000])
      (define-values (_ time) (call/cpu (lambda () (run n))))
      (if (< time 20) (loop (* n 4)) n)))
  (define times
    (for/list ([_ (in-range 7)])
      (define-values (_ time) (call/cpu (lambda () (run count))))
      (/ (* 1e6 time) count)))
  (apply min times))

(module+ main
  (define name (string->symbol (vector-ref (current-command-line-arguments) 0)))
  (write (cond [(find-task name) => measure-task]
               [(find-micro name) => measure-micro]
               [else (raise-user-error 'bench "no task ~a" name)])))
