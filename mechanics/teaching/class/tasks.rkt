#lang racket/base
;; How many tasks, processes and their threads, a user has at present, as Linux tells in /proc.

(provide tasks-of owner)

;; user : number of a user -> number; 0 where there is no /proc
(define (tasks-of user)
  (for/sum ([process (in-list (processes))] #:when (eqv? user (owner process)))
    (length (entries (build-path process "task")))))

(define (processes)
  (for/list ([name (in-list (entries "/proc"))] #:when (regexp-match? #rx"^[0-9]+$" name))
    (build-path "/proc" name)))

;; A process may end while it is looked at.
(define (entries folder)
  (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (directory-list folder)))

;; -> number of the user whose it is, or #f
(define (owner path)
  (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
    (hash-ref (file-or-directory-stat path) 'user-id)))
