#lang racket/base
;; The cost of a process: the seconds in which it kept others waiting, without those in which the
;; system kept it waiting; and the number of a user's tasks.
;;
;; On a busy machine a program waits for a processor, which is no fault of its own; a sleeping
;; program keeps its place from others, and one that starts further processes uses more than its
;; own time.  So the cost between two readings is the greater of
;;
;;   passed − waited    the time by the clock, without that in which the program could have
;;                      run, and had no processor
;;   used               the processors' time of the process and of all that came from it.
;;
;; Linux tells both in /proc.  Where it does not, all time that passes is the program's.

(require (only-in racket/file file->string)
         (only-in racket/list filter-map)
         (only-in racket/string string-split))

(provide (struct-out reading) read-cost read-on cost-between waits-known? children-of
         tasks-of owner)

;; clock, waited, used : seconds, since some time each
(struct reading (clock waited used) #:transparent)

(define (cost-between from to)
  (define (gone field) (- (field to) (field from)))
  (max (- (gone reading-clock) (gone reading-waited)) (gone reading-used)))

;; id : of a process; first-child? : is the program not this process, but the first it started?
(define (read-cost id first-child?)
  (define children (if first-child? (children-of id) '()))
  (reading (/ (current-inexact-milliseconds) 1000.)
           (waited (if (pair? children) (car children) id))
           (used id)))

;; The next reading; a process that has ended keeps the last one.
(define (read-on last id first-child?)
  (define now (read-cost id first-child?))
  (define (greatest field) (max (field last) (field now)))
  (reading (greatest reading-clock) (greatest reading-waited) (greatest reading-used)))

;; Does the system tell how long its processes wait?
(define (waits-known?) (positive? (waited "self")))

;; ---------------------------------------------------------------------------
;; The files of Linux in /proc (man 5 proc)

;; Nanoseconds with a processor, nanoseconds without one, times it had one.
(define (waited id)
  (define found (numbers (about id "schedstat")))
  (if (= 3 (length found)) (/ (cadr found) 1e9) 0.))

;; Hundredths of a second, by the program and by the system, of the process and of its children
;; that have ended: four numbers of those that follow its name, which may be any text.
(define (used id)
  (define m (regexp-match #rx"[)] [^)]*$" (about id "stat")))
  (define found (if m (numbers (car m)) '()))
  (define own
    (for/sum ([n (in-list found)] [i (in-range (+ first-time 4))] #:when (>= i first-time)) n))
  (apply + (/ own 100.) (map used (children-of id))))

(define first-time 10)           ; of the numbers that follow the letter of its state

(define (children-of id) (numbers (about id (format "task/~a/children" id))))

;; A process may end while it is looked at.
(define (about id name)
  (with-handlers ([exn:fail:filesystem? (lambda (e) "")])
    (file->string (format "/proc/~a/~a" id name))))

(define (numbers text) (filter-map string->number (string-split text)))

;; ---------------------------------------------------------------------------
;; Tasks: processes and their threads

;; user : number of a user -> number; 0 where there is no /proc
(define (tasks-of user)
  (for*/sum ([name (in-list (entries "/proc"))]
             #:when (regexp-match? #rx"^[0-9]+$" name)
             [process (in-value (build-path "/proc" name))]
             #:when (eqv? user (owner process)))
    (length (entries (build-path process "task")))))

;; A process may end while it is looked at.
(define (entries folder)
  (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (directory-list folder)))

;; -> number of the user who owns the file, or #f
(define (owner path)
  (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
    (hash-ref (file-or-directory-stat path) 'user-id)))
