#lang racket/base
;; Many motions: by one process and by several, with events, with workers that are killed.

(require compiler/find-exe
         (only-in racket/list last range remove-duplicates)
         racket/port
         racket/runtime-path
         racket/system
         (only-in racket/sequence sequence-map)
         mechanics/book
         mechanics/scale/ensemble/worker-pool
         mechanics/scale/ensemble/task
         mechanics/compile/program
         mechanics
         tests/mechanics/support/own-process
         tests/mechanics/support/skip
         "../../support/checks.rkt")

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define count 100)
(define starts (for/list ([k count]) (up 0 (* 0.02 k) 0.1)))
(define parameters (for/list ([k count]) (list 1.0 (+ 1 (* 0.01 k)) 9.8)))

(define (follow #:jobs [jobs 2] #:observe [each void])
  (evolve-ensemble pendulum starts 5 #:parameters parameters #:jobs jobs #:observe each))

(define alone (follow #:jobs 1))

(test-case "rows of parameters by the name of one"
  (check-equal? (sweep '((m 1) (l 2) (g 9.8)) 'l '(1 2.5)) '((1 1 9.8) (1 2.5 9.8)))
  (check-equal? (sweep '((m 1)) 'm (in-range 3)) '((0) (1) (2))))

(test-case "as one by one, in the order of the starts, by however many"
  (check-equal? (length alone) count)
  (for ([state alone] [start starts] [ps parameters] [k count] #:when (zero? (modulo k 9)))
    (define one ((apply state-advancer pendulum ps) start 5))
    (for ([a (structure->list state)] [b (structure->list one)]) (check-= a b 1e-8)))
  (check-equal? (follow #:jobs 3) alone))

(test-case "values of the last states are collected, there or here, and folded in order"
  (define (angle s) (ref s 1))
  (define (named s) (if (> (ref s 1) 0) 'right 'left)) ; no code: it decides
  (define (collected f #:jobs [jobs 2])
    (evolve-ensemble pendulum starts 5 #:parameters parameters #:collect f #:jobs jobs))
  (check-equal? (collected angle) (map angle alone))
  (check-equal? (collected named) (map named alone))
  (check-equal? (collected (lambda (s) (up (ref s 2) (down (ref s 1) 1))) #:jobs 1)
                (map (lambda (s) (up (ref s 2) (down (ref s 1) 1.0))) alone))
  (define seen '())
  (define sum
    (evolve-ensemble pendulum starts 5 #:parameters parameters #:collect angle
                     #:fold + #:initial 0.0
                     #:observe (lambda (k v) (set! seen (cons k seen)))))
  (check-equal? sum (for/fold ([sum 0.0]) ([s alone]) (+ (angle s) sum)))
  (check-equal? (reverse seen) (range count)))

(test-case "workers keep to the tolerance that was asked for"
  (define (loose jobs)
    (evolve-ensemble pendulum starts 5 #:parameters parameters #:jobs jobs #:tolerance 1e-4))
  (define by-two (loose 2))
  (check-equal? by-two (loose 1))
  (check-false (equal? by-two alone))
  (for ([a by-two] [b alone]) (check-= (ref a 1) (ref b 1) 1e-2)))

(test-case "a start that fails is a value that says so, and the others go on"
  (define f (Hamiltonian->state-derivative (lambda (s) (- (* 1/2 (square (ref s 2)))
                                                          (/ 1 (ref s 1))))))
  (for ([jobs '(1 2)])
    (define all
      (evolve-ensemble f (for/list ([k 40]) (up 0 1.0 (if (= k 17) 0.0 2.0))) 3 #:jobs jobs))
    (define failed (list-ref all 17))
    (check-pred ensemble-failure? failed)
    (check-equal? (ensemble-failure-index failed) 17)
    (check-= (ref (ensemble-failure-state failed) 0) (/ pi 2 (sqrt 2)) 1e-6)
    (check-regexp-match #rx"^evolve-ensemble: the motion cannot be followed any further"
                        (ensemble-failure-message failed))
    (check-regexp-match #rx"^.ensemble-failure 17 " (format "~v" failed))
    (check-equal? (length (remove-duplicates (remove failed all))) 1)))

(test-case "what has no code is followed here, and so is a state without a clock"
  (define (bouncing s) (up 1 (if (> (ref s 1) 0) -1.0 1.0)))
  (define ends (evolve-ensemble bouncing (list (up 0 1.0) (up 0 3.0)) 2.0
                                #:method 'Dormand-Prince-54 #:tolerance 1e-3))
  (check-= (ref (cadr ends) 1) 1.0 1e-6)
  (define (spin s) (up (- (ref s 1)) (ref s 0)))
  (define turned (evolve-ensemble spin (list (up 1.0 0.0)) pi))
  (check-= (ref (car turned) 0) -1.0 1e-9))

(test-case "starts may be a sequence without an end in sight, all methods by name"
  (define (rows) (sequence-map (lambda (k) (up 0 (* 0.01 k) 0)) (in-range 33)))
  (define by-taylor (evolve-ensemble (pendulum 1.0 1.0 9.8) (rows) 1))
  (check-equal? (length by-taylor) 33)
  (for ([method '(Dormand-Prince-853 Radau-IIA-5 bulirsch-stoer)] [jobs '(1 2 1)])
    (for ([a by-taylor] [b (evolve-ensemble (pendulum 1.0 1.0 9.8) (rows) 1 #:method method
                                            #:jobs jobs)])
      (check-= (ref a 1) (ref b 1) 1e-7))))

;; ---------------------------------------------------------------------------
;; Events

(define bottom (event (lambda (s) (ref s 1)) #:name 'bottom #:direction 'falling))
(define turning (event (lambda (s) (ref s 2)) #:name 'turning #:terminal? #t))
(define still (event (lambda (s) (if (> (ref s 1) 0) 1.0 -1.0)) #:name 'decides))

;; Time and state of each: states are compared to the last bit.
(define (told occurrences)
  (for/list ([o occurrences])
    (list (occurrence-time o) (occurrence-state o))))

(define (watched events jobs [collect #f])
  (evolve-ensemble pendulum (cdr starts) 5 #:parameters (cdr parameters) #:jobs jobs
                   #:events events #:collect collect))

(test-case "events of each motion are those of its trajectory, by however many"
  (define all (watched bottom 1))
  (check-equal? (map told (watched bottom 2)) (map told all))
  (for ([occurrences all] [start (cdr starts)] [ps (cdr parameters)] [k 99]
        #:when (zero? (modulo k 20)))
    (define tr (evolve-trajectory (apply pendulum ps) start 5 #:events bottom))
    (check-equal? (length occurrences) (length (trajectory-events tr)))
    (for ([a occurrences] [b (trajectory-events tr)])
      (check-eq? (occurrence-event a) bottom)
      (check-= (occurrence-time a) (occurrence-time b) 1e-8))))

(test-case "a terminal event ends a motion; #:collect is given its state and the occurrences"
  (define ends (watched (list turning bottom) 2 (lambda (s all) (list s (last all)))))
  (for ([end ends])
    (define o (cadr end))
    (check-eq? (occurrence-event o) turning)
    (check-equal? (car end) (occurrence-state o))
    (check-= (ref (car end) 2) 0 1e-12)))

(test-case "an event without code is watched here"
  (check-equal? (for/list ([all (watched still 2)]) (length all))
                (for/list ([all (watched (event (lambda (s) (ref s 1))) 1)]) (length all))))

(test-case "a start that fails is no list of events, and the others are"
  (define f (Hamiltonian->state-derivative (lambda (s) (- (* 1/2 (square (ref s 2)))
                                                          (/ 1 (ref s 1))))))
  (define near (event (lambda (s) (- (ref s 1) 1/2)) #:name 'near))
  (define all
    (evolve-ensemble f (for/list ([k 40]) (up 0 1.0 (if (= k 17) 0.0 2.0))) 3 #:jobs 2
                     #:events near))
  (check-pred ensemble-failure? (list-ref all 17))
  (check-equal? (remove-duplicates (remove (list-ref all 17) all)) '(())))

;; ---------------------------------------------------------------------------
;; Workers that die

(test-case "workers that are killed are replaced: every start once"
  (skip-unless killer? "ensembles: nothing to kill workers with (pkill)"
    (define seen '())
    (define all
      (follow #:observe (lambda (k v)
                          (set! seen (cons k seen))
                          (when (memv k '(0 50)) (kill-children)))))
    (check-equal? all alone)
    (check-equal? (reverse seen) (range count))))

;; As Ctrl-C does, which a terminal tells all processes of a group.
(define-runtime-path long-ensemble "../../support/ensembles/long-ensemble.rkt")
(define kill (find-executable-path "kill"))

(test-case "an interrupt is told once, and no worker is left"
  (skip-unless kill "ensembles: nothing to interrupt processes with (kill)"
    (define-values (process out in errors)
      (parameterize ([subprocess-group-enabled #t])
        (subprocess #f #f #f (find-exe) long-ensemble)))
    (check-equal? (read-line out) "begun")
    (system* kill "-INT" "--" (format "-~a" (subprocess-pid process)))
    (define said (port->string errors)) ; to the end of all that could say anything
    (subprocess-wait process)
    (close-output-port in)
    (check-regexp-match #rx"^user break" said)
    (check-false (regexp-match? #px"worker(?!-pool)" said))))      ; a file of the caller's

(test-case "batches of more than a pipe holds do not stop the crew"
  (define many (for/list ([k 6000]) (up 0.0 (* 1e-4 k) 0.0)))
  (define ends (evolve-ensemble (pendulum 1.0 1.0 9.8) many 0.01 #:batch 2000 #:jobs 2))
  (check-equal? (length ends) 6000)
  (check-equal? (list-ref ends 5999)
                (car (evolve-ensemble (pendulum 1.0 1.0 9.8) (list (list-ref many 5999)) 0.01))))

(test-case "a batch whose workers always die is given up, and told"
  (define nonsense (program 1 (vector (list 'no-such-operation (place 0))) (vector (place 1))))
  (define t (task nonsense #f '() 1 #f 1.0 1e-9 'auto))
  (define left (list (batch 0 '(#(1.0)) '(#())) (batch 1 '(#(2.0)) '(#()))))
  (define (next) (and (pair? left) (begin0 (car left) (set! left (cdr left)))))
  (define given-up '())
  (parameterize ([current-error-port (open-output-nowhere)])
    (perform-by-workers t 1 next
                        (lambda (f) (error "nothing was to be done"))
                        (lambda (b) (set! given-up (cons (batch-index b) given-up)))))
  (check-equal? (sort given-up <) '(0 1)))
