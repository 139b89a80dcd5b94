#lang racket/base
;; What a process has cost: the seconds in which it kept others waiting, and not the system it.
;;
;; On a machine that has much to do a program waits for a processor, which is no fault of its own;
;; one that sleeps keeps its place from others, and one that starts more of its kind uses more
;; than its own time.  So the cost between two readings is the greater of
;;
;;   passed − waited    what the clock says, without the time in which the program could have
;;                      run, and had no processor
;;   used               the processors' time of the process and of all that came from it.
;;
;; Linux tells both in /proc.  Where it does not, all time that passes is the program's.

(require racket/file
         (only-in racket/string string-split))

(provide (struct-out reading) read-cost read-on cost-between waits-known? children-of)

;; clock, waited, used : seconds, since some time each
(struct reading (clock waited used) #:transparent)

(define (cost-between from to)
  (define (gone field) (- (field to) (field from)))
  (max (- (gone reading-clock) (gone reading-waited)) (gone reading-used)))

;; id : of a process; first-child? : is the program not this process, but the first it started?
(define (read-cost id first-child?)
  (define program (if (and first-child? (pair? (children-of id))) (car (children-of id)) id))
  (reading (/ (current-inexact-milliseconds) 1000.) (waited program) (used id)))

;; Of a process that has ended nothing can be read any more; what was known of it stays.
(define (read-on last id first-child?)
  (define now (read-cost id first-child?))
  (define (greatest field) (max (field last) (field now)))
  (reading (greatest reading-clock) (greatest reading-waited) (greatest reading-used)))

;; Does the system tell how long its processes wait?
(define (waits-known?) (positive? (waited "self")))

;; ---------------------------------------------------------------------------
;; What Linux tells (man 5 proc)

;; Nanoseconds with a processor, nanoseconds without one, times it had one.
(define (waited id)
  (define found (numbers (about id "schedstat")))
  (if (= 3 (length found)) (/ (cadr found) 1e9) 0.))

;; In hundredths of a second, by the program and by the system, of it and of its children that
;; have ended: what follows its name, which may be anything, from the twelfth on.
(define (used id)
  (define m (regexp-match #rx"[)] [^)]*$" (about id "stat")))
  (define found (if m (numbers (car m)) '()))
  (define own
    (if (> (length found) first-time)
        (/ (for/sum ([n (in-list (list-tail found first-time))] [_ (in-range 4)]) n) 100.)
        0.))
  (for/fold ([sum own]) ([c (in-list (children-of id))]) (+ sum (used c))))

(define first-time 10)           ; of the numbers that follow the letter of its state

(define (children-of id) (numbers (about id (format "task/~a/children" id))))

;; A process may end while it is looked at.
(define (about id name)
  (with-handlers ([exn:fail:filesystem? (lambda (e) "")])
    (file->string (format "/proc/~a/~a" id name))))

(define (numbers text) (filter values (map string->number (string-split text))))
