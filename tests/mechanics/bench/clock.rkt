#lang racket/base
;; CPU time, finer than a millisecond where the virtual machine tells.

(require ffi/unsafe/vm)

(provide cpu-milliseconds        ; -> real : CPU time of this process
         call/cpu                ; thunk -> (values result milliseconds)
         processes-milliseconds) ; -> CPU time of the processes that have ended

(define cpu-milliseconds
  (if (eq? (system-type 'vm) 'chez-scheme)
      (let ([current-time (vm-primitive 'current-time)]
            [second (vm-primitive 'time-second)]
            [nanosecond (vm-primitive 'time-nanosecond)])
        (lambda ()
          (define t (current-time 'time-process))
          (+ (* 1e3 (second t)) (* 1e-6 (nanosecond t)))))
      current-process-milliseconds))

;; The garbage of what came before is not the thunk's.
(define (call/cpu thunk)
  (collect-garbage)
  (define start (cpu-milliseconds))
  (define result (thunk))
  (define end (cpu-milliseconds))
  (values result (- end start)))

(define (processes-milliseconds) (current-process-milliseconds 'subprocesses))
