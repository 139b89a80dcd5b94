#lang racket/base
;; Files loaded when something of theirs is called: once, whatever happens meanwhile.

(require racket/runtime-path
         "../support/checks.rkt" "../support/patience.rkt")

(define-runtime-path asking "../runner/fixture/on-demand/asking.rkt")
(define-runtime-path here "../runner/fixture/on-demand/here.rkt")

;; (use get space), where (get name) is an export of the fixture, nothing of which is loaded.
(define (call-with-fixture use [file asking])
  (define space (make-base-empty-namespace))
  (define (get name)
    (parameterize ([current-namespace space]) (dynamic-require file name)))
  (use get space))

(define-syntax-rule (with-fixture (get space) body ...)
  (call-with-fixture (lambda (get space) body ...)))

(define (message-of thunk)
  (with-handlers ([exn:fail? exn-message]) (thunk)))

;; Waits until the slow file is being loaded, which goes on when the gate is open.
(define (wait-for-loading get)
  (check-true (eventually (pair? ((get 'events))))))

(define (check-slow-done get)
  ((get 'open-gate))
  (check-equal? ((get 'slow-value)) 1)
  (check-equal? ((get 'events)) '(begun done)))

;; ---------------------------------------------------------------------------

(test-case "a file whose body fails says the same thing every time, and is tried once"
  (with-fixture (get space)
    (for ([name '(one one another)])
      (check-equal? (message-of (get name)) "no such library here"))
    (check-equal? ((get 'events)) '(tried))))

(test-case "a file that stands on one whose body failed says what that said"
  (with-fixture (get space)
    (for ([name '(one standing standing)])
      (check-equal? (message-of (get name)) "no such library here"))))

(test-case "two threads that ask at once load once"
  (with-fixture (get space)
    (define slow (get 'slow-value))
    (define asking (make-semaphore))
    (define threads
      (for/list ([i 3])
        (thread (lambda ()
                  (semaphore-post asking)
                  (slow)))))
    (for ([_ 3]) (semaphore-wait asking))
    (wait-for-loading get)
    ((get 'open-gate))
    (for-each thread-wait threads)
    (check-slow-done get)))

(test-case "a break reaches the caller while the file is loading, and the loading goes on"
  (with-fixture (get space)
    (define slow (get 'slow-value))
    (define seen #f)
    (define caller
      (thread (lambda ()
                (with-handlers ([exn:break? (lambda (e) (set! seen ((get 'events))))])
                  (slow)))))
    (wait-for-loading get)
    (break-thread caller)
    (thread-wait caller)
    (check-equal? seen '(begun))
    (check-slow-done get)))

(test-case "killing the caller does no harm, nor does a limit of time"
  (define ((killed-by kill) get space)
    (define slow (get 'slow-value))
    (kill slow (lambda () (wait-for-loading get)))
    (check-slow-done get))
  (call-with-fixture
   (killed-by (lambda (slow wait)
                (define caller (thread slow))
                (wait)
                (kill-thread caller))))
  (call-with-fixture
   (killed-by (lambda (slow wait)
                (define limits (make-custodian))
                (parameterize ([current-custodian limits]) (thread slow))
                (wait)
                (custodian-shutdown-all limits)))))

(test-case "a file that is being loaded may ask for another"
  (with-fixture (get space)
    ((get 'open-gate))
    (check-equal? ((get 'nested-value)) 2)))

(test-case "who holds the lock of the namespace may ask"
  (with-fixture (get space)
    (define slow (get 'slow-value))
    ((get 'open-gate))
    (check-equal? (namespace-call-with-registry-lock space slow) 1)))

(test-case "a file is loaded into the namespace of the one who asks"
  (with-fixture (get space)
    (check-true ((get 'same-namespace?) space))))

(test-case "what wants the caller's thread is loaded there"
  (call-with-fixture
   (lambda (get space) (check-eq? ((get 'loading-thread)) (current-thread)))
   here))

(test-case "a break waits until what is loaded there is whole"
  (call-with-fixture
   (lambda (get space)
     (check-exn exn:break? (lambda () ((get 'whole)) (sleep 0)))
     (check-equal? ((get 'events)) '(begun done))
     (check-equal? ((get 'whole)) 1))
   here))
