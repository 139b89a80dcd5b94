#lang racket/base
;; Many motions: by one process and by several, interrupted and taken up again, with workers
;; that are killed.

(require racket/file
         (only-in racket/list last range remove-duplicates)
         racket/port
         (only-in racket/sequence sequence-map)
         (except-in rackunit fail)
         mechanics/book
         mechanics/ensemble/batch mechanics/ensemble/crew mechanics/ensemble/task
         mechanics/compile/program
         mechanics
         tests/mechanics/support/messages tests/mechanics/support/own-process
         tests/mechanics/support/skip)

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define count 100)
(define starts (for/list ([k count]) (up 0 (* 0.02 k) 0.1)))
(define parameters (for/list ([k count]) (list 1.0 (+ 1 (* 0.01 k)) 9.8)))

(define (follow #:jobs [jobs 2] #:checkpoint [file #f] #:on-each [each void])
  (evolve-ensemble pendulum starts 5 #:parameters parameters #:jobs jobs
                   #:checkpoint file #:on-each each))

(define alone (follow #:jobs 1))

(test-case "as one by one, in the order of the starts, by however many"
  (check-equal? (length alone) count)
  (for ([state alone] [start starts] [ps parameters] [k count] #:when (zero? (modulo k 9)))
    (define one ((apply state-advancer pendulum ps) start 5))
    (for ([a (structure->list state)] [b (structure->list one)]) (check-= a b 1e-8)))
  (check-equal? (follow) alone)
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
                     #:fold + #:from 0.0
                     #:on-each (lambda (k v) (set! seen (cons k seen)))))
  (check-equal? sum (for/fold ([sum 0.0]) ([s alone]) (+ (angle s) sum)))
  (check-equal? (reverse seen) (range count)))

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
    (check-regexp-match #rx"cannot be followed any further" (ensemble-failure-message failed))
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
  (check-equal? (length (evolve-ensemble (pendulum 1.0 1.0 9.8) (rows) 1)) 33)
  (define by-taylor (evolve-ensemble (pendulum 1.0 1.0 9.8) (rows) 1))
  (for ([method '(Dormand-Prince-853 Radau-IIA-5 bulirsch-stoer)])
    (for ([a by-taylor] [b (evolve-ensemble (pendulum 1.0 1.0 9.8) (rows) 1 #:method method)])
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
      (follow #:on-each (lambda (k v)
                          (set! seen (cons k seen))
                          (when (memv k '(0 50)) (kill-children)))))
    (check-equal? all alone)
    (check-equal? (reverse seen) (range count))))

(test-case "batches of more than a pipe holds do not stop the crew"
  (define many (for/list ([k 6000]) (up 0.0 (* 1e-4 k) 0.0)))
  (define ends (evolve-ensemble (pendulum 1.0 1.0 9.8) many 0.01 #:batch 2000 #:jobs 2))
  (check-equal? (length ends) 6000)
  (check-equal? (list-ref ends 5999)
                (car (evolve-ensemble (pendulum 1.0 1.0 9.8) (list (list-ref many 5999)) 0.01))))

(test-case "a batch whose workers always die is given up, and told"
  (define nonsense (program 1 (vector (list 'no-such-operation (place 0))) (vector (place 1))))
  (define t (task nonsense #f #f '() 1 #f 1.0 1e-9 'auto))
  (define left (list (batch 0 '(#(1.0)) '(#())) (batch 1 '(#(2.0)) '(#()))))
  (define (next) (and (pair? left) (begin0 (car left) (set! left (cdr left)))))
  (define given-up '())
  (parameterize ([current-error-port (open-output-nowhere)])
    (perform-by-crew t 1 next
                     (lambda (f) (error "nothing was to be done"))
                     (lambda (b) (set! given-up (cons (batch-index b) given-up)))))
  (check-equal? (sort given-up <) '(0 1)))

;; ---------------------------------------------------------------------------
;; Checkpoints

(define-syntax-rule (with-file file body ...)
  (let ([file (make-temporary-file "ensemble~a")])
    (dynamic-wind void
                  (lambda () (delete-file file) body ...)
                  (lambda () (when (file-exists? file) (delete-file file))))))

(test-case "an interrupted run goes on where it was, though its last words were cut off"
  (with-file file
    (check-exn #rx"enough"
               (lambda ()
                 (follow #:jobs 1 #:checkpoint file
                         #:on-each (lambda (k v) (when (= k 47) (error "enough"))))))
    (define kept (file-size file))
    (check-true (> kept 1000))
    (call-with-output-file file #:exists 'append (lambda (port) (write-bytes #"\5\0\0\0" port)))
    (check-equal? (follow #:checkpoint file) alone)
    ;; all of it is there now
    (define whole (file-size file))
    (check-equal? (follow #:jobs 1 #:checkpoint file) alone)
    (check-equal? (file-size file) whole)))

(test-case "a break in mid-run leaves a checkpoint that the same call goes on from"
  (with-file file
    (define here (current-thread))
    (define broken?
      (with-handlers ([exn:break? (lambda (e) #t)])
        (follow #:checkpoint file #:on-each (lambda (k v) (when (= k 40) (break-thread here))))
        #f))
    (check-true broken?)
    (define kept (file-size file))
    (check-true (> kept 1000))
    (define seen 0)
    (check-equal? (follow #:checkpoint file #:on-each (lambda (k v) (set! seen (+ seen 1)))) alone)
    (check-equal? seen count)
    (check-true (>= (file-size file) kept))))

(test-case "a checkpoint of another system, or of other events, is refused"
  (with-file file
    (define (sideways m l g) (Lagrangian->state-derivative (L-pendulum (* -1 g) m l)))
    (define (again #:maker [maker pendulum] #:events [events '()])
      (evolve-ensemble maker starts 5 #:parameters parameters #:jobs 1 #:checkpoint file
                       #:events events))
    (again)
    (define before (file->bytes file))
    (for ([call (list (lambda () (again #:maker sideways)) (lambda () (again #:events bottom)))])
      (check-exn #rx"checkpoint is of another ensemble" call)
      (check-equal? (file->bytes file) before))))

(test-case "a checkpoint of something else is refused and left as it is"
  (with-file file
    (follow #:jobs 1 #:checkpoint file)
    (define before (file->bytes file))
    (check-exn #rx"checkpoint is of another ensemble"
               (lambda () (evolve-ensemble pendulum starts 6 #:parameters parameters
                                           #:checkpoint file)))
    (check-exn #rx"other starts or parameters, from start 0"
               (lambda () (evolve-ensemble pendulum (reverse starts) 5 #:parameters parameters
                                           #:checkpoint file)))
    (check-equal? (file->bytes file) before)
    (call-with-output-file file #:exists 'truncate (lambda (port) (write-string "my notes" port)))
    (check-exn #rx"no checkpoint" (lambda () (follow #:checkpoint file)))
    (check-equal? (file->string file) "my notes")))

;; ---------------------------------------------------------------------------

(test-case "a Lagrangian is no state derivative"
  (check-exn #rx"another shape than the state.*[(]Lagrangian->state-derivative L[)] makes"
             (lambda () (evolve-ensemble (L-pendulum 9.8 1 1) (list (up 0 1 0)) 1))))

(define free (pendulum 1 1 9.8))

(says
 [(evolve-ensemble free '() 1) "evolve-ensemble: there are no starts"]
 [(evolve-ensemble free (up 0 1 0) 1)
  "evolve-ensemble: expected the starts as a list or another sequence of states\n"
  "  given: (up 0 1 0), an up tuple of 3"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 1)) 1)
  "evolve-ensemble: start 1 has 2 numbers, the first one 3\n  start: (up 0 1)"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 +nan.0 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (up 0 +nan.0 0)"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 'x 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (up 0 x 0)"]
 [(evolve-ensemble pendulum (list (up 0 1 0) (up 0 1 0)) 1 #:parameters '((1 1 9.8)))
  "evolve-ensemble: there are more starts than rows of parameters\n  from: 1"]
 [(evolve-ensemble pendulum (list (up 0 1 0)) 1 #:parameters '(1 1 9.8))
  "evolve-ensemble: the parameters of a start are a list of numbers and tuples of them\n"
  "  of start 0: 1"]
 [(evolve-ensemble (lambda (s) (up 1 (ref s 2) (ref s 1) 7)) (list (up 0 1.0 0.0)) 2)
  "evolve-ensemble: the state derivative is of another shape than the state\n"
  "  state: (up 0 1.0 0.0)\n  derivative: (up 1 0.0 1.0 7)"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:checkpoint "/no/such/folder/a")
  "evolve-ensemble: there is no such folder for the checkpoint\n  folder: /no/such/folder/"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:jobs 0)
  "evolve-ensemble: #:jobs is a positive integer\n  given: 0"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:method (leapfrog 0.1))
  "evolve-ensemble: methods are told to other processes by name\n  given: (leapfrog 0.1)"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:collect 3)
  "evolve-ensemble: #:collect is a procedure of a state\n  given: the number 3"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events 3)
  "evolve-ensemble: expected events; (event f) makes one of a function of the state\n"
  "  given: the number 3"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:collect (lambda (s) s))
  "evolve-ensemble: #:collect is a procedure of a state and a list of occurrences, with #:events\n"
  "  given: a function without a name"]
 [(evolve-ensemble (list (up 0 1 0)) free 1)
  "evolve-ensemble: the state derivative comes first, then the starts\n"
  "  given first: ((up 0 1 0)), a list"]
 [(evolve-ensemble free 1 (list (up 0 1 0)))
  "evolve-ensemble: the starts come before the time where they end\n"
  "  given second: the number 1"])
