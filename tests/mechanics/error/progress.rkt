#lang racket/base
;; Word of progress on long runs: when it is given, where, and that it goes away.

(require mechanics
         mechanics/book
         mechanics/error/progress
         mechanics/plot
         "../support/checks.rkt")

;; A reporter whose clock goes on by `tick` ms each time it is read.
(define (reporter-on port tick)
  (define now 0)
  (reporter port (lambda () (set! now (+ now tick)) now)))

;; The text that (f) makes a terminal show, and its value.
(define (shown f #:tick [tick 100])
  (define port (open-output-string))
  (define value (parameterize ([current-reporter (reporter-on port tick)]) (f)))
  (values (get-output-string port) value))

(define (lines text) (regexp-match* #rx"\r([^\e]*)\e\\[K" text #:match-select cadr))

;; Each step of a made-up computation says where it is.
(define (steps n)
  (call-with-progress #t
    (lambda (note!)
      (for ([k n]) (note-progress note! (format "step ~a" k)))
      n)))

(define (harmonic) (lambda (s) (up 1 (velocity s) (* -1 (coordinate s)))))
(define (advance . options)
  (keyword-apply (state-advancer harmonic) '(#:progress?) options (list (up 0. 1. 0.) 200 1e-12)))

;; ---------------------------------------------------------------------------

(test-case "nothing for three seconds, then four lines a second, erased in the end"
  (define-values (text value) (shown (lambda () (steps 100))))
  (check-equal? value 100)
  (define said (lines text))
  (check-equal? (car said) "step 29")
  (check-equal? (cadr said) "step 32")
  (check-equal? (length said) 25)
  (check-equal? (regexp-replace* #rx"\r[^\e]*\e\\[K" text "") "")
  (check-regexp-match #rx"\r\e\\[K$" text)
  (define-values (brief n) (shown (lambda () (steps 20))))
  (check-equal? brief "")
  (define-values (each m) (shown (lambda () (steps 14)) #:tick 250))
  (check-equal? (lines each) '("step 11" "step 12" "step 13" "")))

(test-case "an error and a break erase the line, and go on"
  (define (failing e)
    (lambda ()
      (call-with-progress #t
        (lambda (note!)
          (for ([k 100]) (note-progress note! "far"))
          (raise e)))))
  (for ([e (list (exn:fail "no" (current-continuation-marks)) 'stop)])
    (define-values (text value)
      (shown (lambda () (with-handlers ([void values]) ((failing e))))))
    (check-equal? value e)
    (check-regexp-match #rx"\r\e\\[K$" text))
  (define port (open-output-string))
  (define noted (make-semaphore))
  (define t
    (thread
     (lambda ()
       (with-handlers ([exn:break? void])
         (parameterize ([current-reporter (reporter-on port 5000)])
           (call-with-progress #t
             (lambda (note!)
               (note-progress note! "far")
               (semaphore-post noted)
               (sync never-evt))))))))
  (semaphore-wait noted)
  (break-thread t)
  (thread-wait t)
  (check-equal? (get-output-string port) "\rfar\e[K\r\e[K"))

(test-case "nothing where nobody waits, where it is not wanted, or where output is no terminal"
  (check-false (current-reporter))
  (check-equal? (call-with-progress #t values) #f)
  (define-values (text value) (shown (lambda () (advance #f))))
  (check-equal? text "")
  (define-values (text2 value2)
    (shown
     (lambda () (parameterize ([report-progress #f]) ((state-advancer harmonic) (up 0 1 0) 100)))))
  (check-equal? text2 "")
  (parameterize ([current-error-port (open-output-string)])
    (check-false (terminal-reporter))))

(test-case "nothing where the computation writes itself"
  (define out (open-output-string))
  (define-values (text value)
    (parameterize ([current-output-port out])
      (shown (lambda ()
               ((evolve harmonic) (up 0 1 0) (lambda (s) (display ".")) 1 100)))))
  (check-equal? text ""))

(test-case "a motion says how far it is, and comes to what it comes to without"
  (define-values (text value) (shown (lambda () (advance #t))))
  (check-equal? value (advance #f))
  (check-regexp-match #px"^state-advancer: t = \\d+[.]\\d of 200[.]0$" (car (lines text)))
  (define-values (text2 last)
    (shown (lambda () ((evolve harmonic) (up 0 1 0) void 1 200 1e-12))))
  (check-regexp-match #px"^evolve: t = " (car (lines text2)))
  (define-values (text3 trajectory)
    (shown (lambda () (evolve-trajectory (harmonic) (up 0 1 0) 200 #:tolerance 1e-12))))
  (check-regexp-match #px"^evolve-trajectory: t = " (car (lines text3))))

(test-case "searches say how many steps they took"
  (define-values (text path)
    (shown #:tick 1500
           (lambda ()
             (find-path (lambda (s) (* 1/2 (- (expt (velocity s) 2) (expt (coordinate s) 2))))
                        0. 1. 1.5 0. 3))))
  (check-regexp-match #px"^find-path: \\d+ steps, value " (car (lines text)))
  (define-values (text2 x)
    (shown #:tick 1500
           (lambda ()
             (multidimensional-minimize
              (lambda (s) (+ (expt (- (ref s 0) 1) 4) (expt (- (ref s 1) 2) 2))) (up 0. 0.)))))
  (check-regexp-match #px"^multidimensional-minimize: \\d+ steps, value " (car (lines text2)))
  (define-values (text3 m) (shown #:tick 1500 (lambda () (minimize cos 1. 5.))))
  (check-regexp-match #px"^minimize: \\d+ steps, value " (car (lines text3))))

(test-case "pictures of many points say how many there are"
  (define f (frame 0 :2pi 0 :2pi))
  (define T (standard-map 0.6))
  (define (said draw) (let-values ([(text value) (shown draw)]) (lines text)))
  (define (check-said pattern draw)
    (define all (filter (lambda (line) (not (equal? line ""))) (said draw)))
    (check-true (pair? all))
    (for ([line all]) (check-regexp-match pattern line)))
  (check-said #px"^explore-map: \\d+ of 202 points$"
              (lambda () (explore-map f T 100 #:starts (list (up 1 1) (up 2 2)))))
  (check-said #px"^display-map: \\d+ of 101 points$" (lambda () (display-map f T 1 1 100)))
  (check-said #px"^explore-map: \\d+ of 49 orbits$"
              (lambda () (explore-map f (lambda (x y done fail) (done x y)) #f #:grid '(7 7))))
  (check-said #px"^chaos-map: \\d+ of 200 rows$"
              (lambda () (chaos-map f (lambda (x y done fail) (done x y)) 1 #:samples '(1 200))))
  (check-said #px"^plot-function: \\d+ of 501 points$" (lambda () (plot-function f sin 0 1)))
  (check-said #px"^plot-contours: \\d+ of 101 rows$" (lambda () (plot-contours f * 1)))
  (check-said #px"^plot-parametric-fill: \\d+ points$"
              (lambda () (plot-parametric-fill f (lambda (t) (up t t)) 0 6))))
